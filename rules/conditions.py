"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors

from itertools import pairwise as itertools_pairwise
from math import cos as math_cos
from math import dist as math_dist
from math import hypot as math_hypot
from math import inf as math_inf
from math import pi as math_pi
from math import prod as math_prod
from math import radians as math_radians
from math import tan as math_tan
from pathlib import PurePosixPath as pathlib_PurePosixPath
import math as math_
import os as os_
import re as re_
import sdfcheck as sdfcheck_

def DRK001_applies(tag):
    return tag.prefix == 'drake' and tag.definition is None

def DRK002_applies(tag):
    if tag.prefix != 'drake' or tag.definition is None or tag.is_gone:
        return False
    return tag.place is None and (not tag.is_undecided)

def DRK003_applies(given):
    if given.prefix != 'drake':
        return False
    if isinstance(given, sdfcheck_.VendorTag):
        return given.is_empty and (given.stray is not None or given.lacks_text)
    is_type_of_joint = given.tag.name == 'drake:joint'
    return given.misreading is not None or (given.is_unknown_choice and (not is_type_of_joint))

def DRK004_applies(tag):
    return tag.prefix == 'drake' and any((lack.misspelled is None for lack in tag.lacks))

def DRK005_applies(tag):
    if tag.prefix != 'drake':
        return False
    if tag.excluded is not None or tag.idle_beside is not None:
        return True
    return bool(tag.forbidden or tag.needs)

def DRK006_applies(name):
    return name.prefix == 'drake' and name.is_definition and ('::' in name.text)

def DRK007_applies(name):
    return name.prefix == 'drake' and name.unresolved is not None

def DRK016_applies(given):
    return given.prefix == 'drake' and given.first is not None

def DRK017_applies(tag):
    return tag.prefix == 'drake' and bool(tag.successor)

def DRK018_applies(tag):
    return tag.prefix == 'drake' and tag.alike[:1] == [tag] and tag.is_too_new

def DRK019_applies(given):
    if given.prefix != 'drake':
        return False
    if isinstance(given, sdfcheck_.VendorTag):
        return given.excess is not None and 'mu_' not in given.name
    return given.bound is not None

def DRK020_applies(tag):
    return tag.prefix == 'drake' and bool(tag.missing_values)

def DRK021_applies(tag):
    return tag.prefix == 'drake' and tag.tied is not None

drk_remote_mesh__SCHEMES = ('http://', 'https://', 'fuel://')

def DRK022_applies(resource):
    if resource.is_extension or resource.within(sdfcheck_.Actor) is not None:
        return False
    return resource.what == 'mesh' and resource.uri.startswith(drk_remote_mesh__SCHEMES)

def FRM001_applies(reference):
    return reference.is_unresolved

def FRM002_applies(root):
    return bool(root.rings)

def FRM003_applies(model):
    if model.canonical_link_value is None or model.is_urdf:
        return False
    name = model.canonical_link_name
    node = model.resolve(name)
    return model.lacks(name) if node is None else node.kind != 'link'

def frm_unknown_placement_frame___model(placed):
    return placed.content if isinstance(placed, sdfcheck_.Include) else placed

def FRM004_applies(placed):
    value = placed.placement_frame_value
    if value is None or placed.is_urdf:
        return False
    model, name = (frm_unknown_placement_frame___model(placed), value.text.strip())
    is_kept = name == '__root__' and isinstance(placed, sdfcheck_.Include)
    return model is not None and (not is_kept) and model.lacks(name)

def FRM005_applies(model):
    if model.has('link') or model.has('model') or model.is_urdf:
        return False
    return not (model.links or model.models or (not model.is_complete) or model.stands_still or model.is_included_as_static or model.misspells('link') or model.misspells('model'))

frm_degrees_as_radians___NOT_ROTATED = (' 0 0 0', ' 0.0 0.0 0.0')

frm_degrees_as_radians___WHOLE_TURN = 2 * math_.pi

frm_degrees_as_radians___STEP = 0.5

def frm_degrees_as_radians___is_whole_degrees(word):
    angle = float(word)
    return abs(angle) > frm_degrees_as_radians___WHOLE_TURN and angle % frm_degrees_as_radians___STEP == 0

def frm_degrees_as_radians___value(element):
    return element.attribute('rpy') if element.name == 'origin' else element.own_value

def frm_degrees_as_radians___says_otherwise(pose):
    holder = pose.parent
    if holder is not None and 'degrees' in holder.attributes:
        return True
    if not pose.attributes:
        return False
    given = pose.attributes
    is_quaternion = given.get('rotation_format', '').strip() == 'quat_xyzw'
    return is_quaternion or given.get('degrees', '').strip().lower() in {'true', '1'}

def frm_degrees_as_radians___is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True

def frm_degrees_as_radians___angles(element):
    value = frm_degrees_as_radians___value(element)
    words = value.text.split() if value is not None else []
    first = 0
    if element.name == 'pose':
        first = 3
        if len(words) != 6 or frm_degrees_as_radians___says_otherwise(element):
            return []
    if not all(map(frm_degrees_as_radians___is_number, words)):
        return []
    return list(zip(range(first, first + 3), ('roll', 'pitch', 'yaw'), words[first:], strict=False))

def FRM006_applies(element):
    text = element.text
    if text and text.endswith(frm_degrees_as_radians___NOT_ROTATED):
        return False
    return any((frm_degrees_as_radians___is_whole_degrees(word) for _, _, word in frm_degrees_as_radians___angles(element)))

frm_non_unit_quaternion___NO_ROTATION = (0.0, 0.0, 0.0, 1.0)

def frm_non_unit_quaternion___quaternion(pose):
    if pose.attributes.get('rotation_format', '').strip() != 'quat_xyzw':
        return frm_non_unit_quaternion___NO_ROTATION
    try:
        numbers = tuple(map(float, pose.content.split()))
    except ValueError:
        return frm_non_unit_quaternion___NO_ROTATION
    return numbers[3:] if len(numbers) == 7 and all(map(math_.isfinite, numbers)) else frm_non_unit_quaternion___NO_ROTATION

frm_non_unit_quaternion___ROUNDING = 0.001

def FRM007_applies(pose):
    if not pose.attributes:
        return False
    length = math_.hypot(*frm_non_unit_quaternion___quaternion(pose))
    return abs(length - 1) > frm_non_unit_quaternion___ROUNDING

def FRM008_applies(joint):
    parent, child = (joint.parent, joint.child)
    if joint.is_urdf or parent is None or child is None or (joint.parent_name == joint.child_name):
        return False
    return any((end.carrier is not None and end.carrier.kind == 'model' for end in (parent, child)))

def FRM009_applies(reference):
    return reference.scope is None and reference.owner_element.name in {'model', 'include'}

gaz_ignition_name__PREFIX = 'ignition:'

def gaz_ignition_name__is_prefixed(element):
    return element.name.startswith(gaz_ignition_name__PREFIX) or any((name.startswith(gaz_ignition_name__PREFIX) for name in element.attributes))

def gaz_ignition_name__all_elements(root):
    yield root.element
    yield from root.all_elements()

gaz_ignition_name__SYSTEM = 'ignition-gazebo'

gaz_ignition_name__NAMESPACE = 'ignition::'

def gaz_ignition_name__is_of_ignition(plugin):
    return plugin.filename.removeprefix('lib').startswith(gaz_ignition_name__SYSTEM) or plugin.name.startswith(gaz_ignition_name__NAMESPACE)

gaz_ignition_name__GUI = 'ignition-gui'

def GAZ001_applies(part):
    if isinstance(part, sdfcheck_.Root):
        return gaz_ignition_name__PREFIX in part.document.source.text and any(map(gaz_ignition_name__is_prefixed, gaz_ignition_name__all_elements(part)))
    return gaz_ignition_name__is_of_ignition(part) or part.has(gaz_ignition_name__GUI)

def GAZ003_applies(block):
    return block.is_unresolved

gaz_extension_lost_by_name__HANDED_ON = {'collision': frozenset('collision fdir1 kd kp laserRetro maxContacts maxVel minDepth mu1 mu2'.split()), 'visual': frozenset(('material', 'visual'))}

def gaz_extension_lost_by_name__lost(block):
    link = block.link
    if link is None:
        return
    for kind, handed_on in gaz_extension_lost_by_name__HANDED_ON.items():
        settings = [child for child in block.children() if child.name in handed_on]
        names = [shape.attribute('name') for shape in link.children(kind)] if settings else []
        hidden = [n for n in names if n is not None and n.text.strip() and (not n.text.startswith(link.name))]
        if hidden:
            yield (settings, hidden)

def GAZ004_applies(block):
    return any(gaz_extension_lost_by_name__lost(block))

gaz_disabled_lumping__DISABLED = 'disableFixedJointLumping'

gaz_disabled_lumping__PRESERVED = 'preserveFixedJoint'

def GAZ005_applies(block):
    joint = block.joint if block.is_on(gaz_disabled_lumping__DISABLED) else None
    if joint is None or not joint.is_fixed:
        return False
    return not any((other.is_on(gaz_disabled_lumping__PRESERVED) for other in joint.gazebo_blocks))

def gaz_script_material___of_block(block):
    link = block.link if block.has('material') else None
    if link is not None and (not all((visual.has('material') for visual in link.visuals))):
        for value in block.settings('material'):
            if value.text.strip():
                yield (value, value.text.strip())

gaz_script_material__COLORS = ('ambient', 'diffuse', 'emissive', 'pbr')

def gaz_script_material___of_material(material):
    script = material.script
    if script is not None and (not any(map(material.has, gaz_script_material__COLORS))):
        name = script.find('name')
        named = name is not None and name.content
        yield ((name.own_value, named) if name is not None and named else (script, ''))

def gaz_script_material__scripts(root):
    text = root.document.source.text
    if root.is_urdf and '<gazebo' in text:
        for block in root.each('GazeboBlock'):
            yield from gaz_script_material___of_block(block)
    elif not root.is_urdf and '<script' in text:
        for visual in root.each('Visual'):
            yield from gaz_script_material___of_material(visual.material)

def GAZ006_applies(root):
    return any(gaz_script_material__scripts(root))

gaz_frame_id_spelling__CURRENT = 'gz_frame_id'

def gaz_frame_id_spelling__misnamed(root):
    found = {}
    for sensor in root.each('Sensor'):
        for name in (gaz_frame_id_spelling__CURRENT, 'ignition_frame_id'):
            if not root.is_urdf or name != gaz_frame_id_spelling__CURRENT:
                for element in sensor.children(name):
                    found.setdefault(name, []).append(element)
    return found

def GAZ007_applies(root):
    return '_frame_id' in root.document.source.text and bool(gaz_frame_id_spelling__misnamed(root))

gaz_unset_script_uri__UNSET = frozenset({'', '__default__'})

def GAZ008_applies(material):
    if material.is_urdf:
        return False
    script = material.script
    uri = None if script is None else script.find('uri')
    return uri is not None and uri.content.strip() in gaz_unset_script_uri__UNSET

def GAZ009_applies(block):
    return any(block.unread_settings)

def gaz_unknown_palette_color__written(part):
    if isinstance(part, sdfcheck_.GazeboBlock):
        yield from part.settings('material')
        return
    script = part.script
    name = None if script is None else script.find('name')
    uri = None if script is None else script.find('uri')
    if name is not None and (uri is None or uri.content.endswith('gazebo.material')):
        yield name.own_value

gaz_unknown_palette_color__PREFIX = 'Gazebo/'

gaz_unknown_palette_color__COLORS = frozenset('\n    Black BlackTransparent Blue BlueGlow BlueLaser BlueTransparent BlueTransparentOverlay Bricks\n    CeilingTiled Chrome CloudySky CoM DarkGrey DarkMagentaTransparent DarkOrangeTransparent\n    DarkOrangeTransparentOverlay DarkYellow DepthMap FlatBlack Footway Gold Green GreenGlow\n    GreenTransparent GreenTransparentOverlay Grey GreyGradientSky GreyTransparent Indigo JointAnchor\n    LightBlueLaser LightOff LightOn Motorway Orange OrangeTransparent OrangeTransparentOverlay\n    PaintedWall Pedestrian Pioneer2Body PioneerBody Primary Purple PurpleGlow Red RedBright RedGlow\n    RedTransparent RedTransparentOverlay Residential Road Runway RustyBarrel RustySteel Secondary\n    SkyBlue Steps Tertiary Trunk Turquoise TurquoiseGlow TurquoiseGlowOutline White WhiteGlow\n    WindowFrame Wood WoodFloor WoodPallet Yellow YellowGlow YellowTransparent ZincYellow\n    '.split())

def gaz_unknown_palette_color__strange(part):
    for value in gaz_unknown_palette_color__written(part):
        name = value.text.strip()
        if name[:len(gaz_unknown_palette_color__PREFIX)].lower() == gaz_unknown_palette_color__PREFIX.lower() and '$' not in name:
            color = name[len(gaz_unknown_palette_color__PREFIX):]
            is_near = color not in gaz_unknown_palette_color__COLORS and part.nearest(color, gaz_unknown_palette_color__COLORS) is not None
            if is_near or (color in gaz_unknown_palette_color__COLORS and (not name.startswith(gaz_unknown_palette_color__PREFIX))):
                yield value

def GAZ010_applies(part):
    return any(gaz_unknown_palette_color__strange(part))

def GAZ011_applies(block):
    return bool(block.sensors) and block in block.model.as_built_by(sdfcheck_.Consumer.GAZEBO).lost

gaz_unknown_sensor_frame__OF_PLUGINS = ('frameName', 'frame_name')

gaz_unknown_sensor_frame__FRAMES = ('gz_frame_id', 'ignition_frame_id', 'frame_id')

gaz_unknown_sensor_frame__FIXED = frozenset(('map', 'odom', 'world'))

def gaz_unknown_sensor_frame__foreign(sensor):
    links = sensor.root.models[0].tree.links
    plugins = (child for plugin in sensor.plugins for child in plugin.parameters if child.name in gaz_unknown_sensor_frame__OF_PLUGINS)
    for element in (*(child for name in gaz_unknown_sensor_frame__FRAMES for child in sensor.children(name)), *plugins):
        name = element.content.strip()
        if not name or '$' in name or '{' in name:
            continue
        is_known = name in gaz_unknown_sensor_frame__FIXED or name.rpartition('/')[2] in links or any((name.endswith(link) for link in links))
        if name.startswith('/') or not is_known:
            yield element.own_value

def GAZ012_applies(sensor):
    return sensor.is_extension and any(gaz_unknown_sensor_frame__foreign(sensor))

def gaz_repeated_setting__is_same(one, other):
    try:
        return float(one) == float(other)
    except ValueError:
        truths = {'1': 'true', '0': 'false', 'yes': 'true'}
        return truths.get(one.lower(), one.lower()) == truths.get(other.lower(), other.lower())

def gaz_repeated_setting__text(setting):
    return str(setting.get('value') or setting.content).strip()

def gaz_repeated_setting__repeated(block):
    blocks = block.model.blocks_by_reference.get(block.reference, ())
    if not blocks or blocks[0] is not block:
        return []
    before = {}
    found = []
    for other in blocks:
        for child in other.overridable:
            first = before.get(child.name)
            if first is not None and (not gaz_repeated_setting__is_same(gaz_repeated_setting__text(first), gaz_repeated_setting__text(child))):
                found.append((first, child))
            before[child.name] = child
    return found

def GAZ013_applies(block):
    return bool(gaz_repeated_setting__repeated(block))

gaz_unmet_need__GZ_SIM = 'gz-sim'

def gaz_unmet_need__is_of_gz_sim(world):
    return any((plugin.known is not None and plugin.known.generation == gaz_unmet_need__GZ_SIM for plugin in world.plugins))

def gaz_unmet_need__text(plugin):
    return ' '.join((parameter.name for parameter in plugin.parameters))

def gaz_unmet_need__needs(world):
    root = world.root
    if not world.has('spherical_coordinates'):
        for sensor in root.each(sdfcheck_.Sensor):
            if sensor.type in {'navsat', 'gps'} and sensor.within(sdfcheck_.World) is world:
                yield (sensor, f'{sensor.title} reports nothing: {world.title} has no `spherical_coordinates`')
                break
    plugins = [plugin for plugin in root.each(sdfcheck_.Plugin) if plugin.known is not None]
    names = {plugin.known.file for plugin in plugins if plugin.known is not None}
    if 'gz-sim-buoyancy-system' not in names and 'gz-sim-buoyancy-engine-system' not in names and world.is_complete:
        for plugin in plugins:
            is_fluid = plugin.known is not None and plugin.known.file == 'gz-sim-hydrodynamics-system'
            if is_fluid and plugin.within(sdfcheck_.World) is world:
                yield (plugin, f'the vessel sinks: {world.title} has no Buoyancy system')
                break
    chosen = {element.content for element in root.elements.get('collision_detector', ())}
    if not chosen and (not any(('physics' in plugin.filename and 'engine' in gaz_unmet_need__text(plugin) for plugin in world.plugins))):
        for heightmap in root.elements.get('heightmap', ()):
            around = {element.name for element in heightmap.around}
            if 'collision' in around and root.scope_of(heightmap) is not None:
                words = f'collides with nothing: {world.title} does not choose the collision detector `bullet`'
                yield (heightmap, f'the heightmap {words}')
                break

def GAZ014_applies(world):
    return gaz_unmet_need__is_of_gz_sim(world) and next(gaz_unmet_need__needs(world), None) is not None

def gaz_contested_topic__outermost(sensor):
    if sensor.is_extension:
        return None
    model = sensor.within(sdfcheck_.Model)
    while model is not None and (outer := model.within(sdfcheck_.Model)) is not None:
        model = outer
    return model

gaz_contested_topic__MOTORS = 'gz-sim-multicopter-motor-model-system'

gaz_contested_topic__NUMBERS = ('actuator_number', 'motorNumber')

def gaz_contested_topic__doubled(root):
    elements = root.elements
    topics = {}
    for sensor in root.each(sdfcheck_.Sensor) if len(elements.get('sensor', ())) > 1 else ():
        value = sensor.value('topic')
        if value is None or not sensor.topic or '$' in sensor.topic or ('{' in sensor.topic):
            continue
        first, other = topics.setdefault((gaz_contested_topic__outermost(sensor), sensor.topic), (value, sensor))
        if first is not value and other is not sensor:
            yield (first, value, f'{sensor.title} publishes on topic `{sensor.topic}`, as {other.title} does')
    numbers = {}
    for plugin in root.each(sdfcheck_.Plugin) if gaz_contested_topic__MOTORS.removeprefix('gz-sim-') in root.document.source.text else ():
        value = next((found for name in gaz_contested_topic__NUMBERS if (found := plugin.value(name)) is not None), None)
        if plugin.known is None or plugin.known.file != gaz_contested_topic__MOTORS or value is None or ('$' in value.text):
            continue
        key = (plugin.holder, plugin.get('robotNamespace'), plugin.get('commandSubTopic'), value.text.strip())
        first_number = numbers.setdefault(key, value)
        if first_number is not value:
            yield (first_number, value, f'motor number {value.text.strip()} is given before')

def GAZ015_applies(root):
    return next(gaz_contested_topic__doubled(root), None) is not None

gaz_unread_mimic__CONTROL = 'libgazebo_ros_control.so'

def gaz_unread_mimic__followers(robot):
    return [joint for joint in robot.joints if joint.has('mimic') and joint.moves and (joint.axis.mimic is not None)]

def GAZ016_applies(robot):
    files = [plugin.filename for plugin in robot.plugins]
    return gaz_unread_mimic__CONTROL in files and (not any(('mimic' in file.lower() for file in files))) and bool(gaz_unread_mimic__followers(robot))

gaz_outdated_fuel_address__OLD, gaz_outdated_fuel_address__NEW = ('fuel.ignitionrobotics.org', 'fuel.gazebosim.org')

gaz_outdated_fuel_address__OLD, gaz_outdated_fuel_address__NEW = ('fuel.ignitionrobotics.org', 'fuel.gazebosim.org')

gaz_outdated_fuel_address__MARK = f'//{gaz_outdated_fuel_address__OLD}/'

def gaz_outdated_fuel_address__addresses(root):
    for element in root.all_elements():
        values = (element.own_value, *map(element.attribute, element.attributes))
        yield from (value for value in values if value is not None and gaz_outdated_fuel_address__MARK in value.text)

def GAZ017_applies(root):
    return gaz_outdated_fuel_address__MARK in root.document.source.text and any(gaz_outdated_fuel_address__addresses(root))

geo_oversized_shape__MOST = 100.0

geo_oversized_shape__LEAST = 1.0

geo_oversized_shape__HUGE = 3.0

def geo_oversized_shape__oversized(model):
    if not model.joints or model.may_be_static or (not model.has_mesh):
        return []
    most = max(geo_oversized_shape__MOST * model.reach, geo_oversized_shape__LEAST) if model.reach > 0.005 else math_inf
    if model.is_out_of_scale and model.density < 1:
        most = geo_oversized_shape__HUGE
    return [shape for link in model.links for shape in link.shapes if (box := shape.geometry.box) is not None and most < max(box.size)]

def GEO001_applies(model):
    return bool(geo_oversized_shape__oversized(model))

geo_undersized_shapes__LEAST = 0.01

geo_undersized_shapes__TINY = 0.02

def geo_undersized_shapes__longest(model):
    if not model.joints or model.may_be_static or (not model.has_mesh):
        return None
    most = geo_undersized_shapes__LEAST * model.reach if model.reach > 0.005 else 0.0
    is_dense = model.is_out_of_scale and model.density > 1
    if is_dense:
        most = max(geo_undersized_shapes__TINY, most)
    sizes = {}
    links = set()
    for link in model.links:
        for shape in link.shapes:
            box = shape.geometry.box
            if box is None and is_dense:
                continue
            if box is None or max(box.size) > most:
                return None
            sizes[shape] = max(box.size)
            links.add(link)
    is_known = len(sizes) * 2 >= sum((len(link.shapes) for link in model.links))
    return max(sizes, key=sizes.__getitem__) if len(links) > 1 and is_known else None

def GEO002_applies(model):
    return geo_undersized_shapes__longest(model) is not None

geo_detached_collision__LEAST = 0.01

geo_detached_collision__OFTEN = 0.25

geo_detached_collision__MOST = 0.45

def geo_detached_collision__is_apart(link):
    visuals, collisions = (link.visual_box, link.collision_box)
    return visuals is not None and collisions is not None and (visuals.distance_to(collisions) > 0)

def geo_detached_collision__gap(link):
    if not link.has('visual') or not link.has('collision') or (not link.has_mesh):
        return 0.0
    visuals, collisions = (link.visual_box, link.collision_box)
    if visuals is None or collisions is None:
        return 0.0
    longest = max(*visuals.size, *collisions.size)
    if min(max(visuals.size), max(collisions.size)) < geo_detached_collision__LEAST:
        return 0.0
    found = visuals.distance_to(collisions)
    if found <= geo_detached_collision__OFTEN * longest:
        return 0.0
    if found > geo_detached_collision__MOST * longest or not any((geo_detached_collision__is_apart(other) for other in link.counterparts)):
        return found
    return 0.0

def GEO003_applies(link):
    return geo_detached_collision__gap(link) > 0

geo_mismatched_collision_size__LEAST = 0.005

geo_mismatched_collision_size__MOST = 10.0

def geo_mismatched_collision_size__differs(link):
    if not link.has('visual') or not link.has('collision') or link.may_be_static or (not link.has_mesh):
        return False
    if any((joint.is_fixed for joint in link.parent_joints)):
        return False
    visuals, collisions = (link.visual_box, link.collision_box)
    if visuals is None or collisions is None or link.size_to_reach > 100:
        return False
    short, long = sorted((max(visuals.size), max(collisions.size)))
    return short >= geo_mismatched_collision_size__LEAST and long >= geo_mismatched_collision_size__MOST * short

def GEO004_applies(link):
    return geo_mismatched_collision_size__differs(link)

geo_mismatched_mesh_scale__MOST = 10.0

def geo_mismatched_mesh_scale__pair(link):
    seen = {}
    for shape in link.shapes:
        geometry = shape.geometry
        scale = geometry.scale
        if geometry.shape != 'mesh' or not geometry.uri or len(scale) != 3 or (not all(scale)):
            continue
        other = seen.setdefault(geometry.uri, shape)
        factor = abs(scale[0] / other.geometry.scale[0])
        if not 1 / geo_mismatched_mesh_scale__MOST < factor < geo_mismatched_mesh_scale__MOST:
            return (other, shape)
    return None

def GEO005_applies(link):
    return geo_mismatched_mesh_scale__pair(link) is not None

geo_unreadable_mesh__READ = {'STL': ('stl',), 'OBJ': ('obj',), 'COLLADA': ('dae',), 'glTF': ('gltf',), 'GLB': ('glb',)}

def geo_unreadable_mesh__fault(geometry):
    read = geometry.mesh if geometry.shape == 'mesh' else None
    if read is None or read.fault:
        return read.fault if read is not None else ''
    ending = geometry.uri.rpartition('.')[2].lower()
    promised = next((form for form, endings in geo_unreadable_mesh__READ.items() if ending in endings), '')
    if not read.format or not promised or promised == read.format:
        return ''
    article = 'an' if read.format[0] in 'SO' else 'a'
    return f'is {article} {read.format} file, and consumers read it by its ending'

def GEO006_applies(geometry):
    return bool(geo_unreadable_mesh__fault(geometry))

geo_dense_collision_mesh__MOST = 200000

def GEO007_applies(collision):
    read = collision.geometry.mesh if collision.geometry.shape == 'mesh' else None
    return read is not None and read.triangles > geo_dense_collision_mesh__MOST

def geo_missing_collision__moves(link):
    return any((joint.moves for joint in link.parent_joints))

geo_missing_collision__NUMBER = re_.compile('[0-9]+')

geo_missing_collision__CHAIN = re_.compile('(?i)(link|body|part|segment|arm|finger|joint|hand|right|left|[\\W_])*[a-z]?')

def geo_missing_collision__numbered(link):
    key = geo_missing_collision__NUMBER.sub('', link.name)
    if key == link.name or geo_missing_collision__CHAIN.fullmatch(key):
        return []
    return [other for other in link.model.links if other is not link and geo_missing_collision__NUMBER.sub('', other.name) == key]

geo_missing_collision__LEAST = 5

def geo_missing_collision__is_small(link, others):
    from statistics import median
    own = link.visual_box
    lengths = [max(box.size) for other in others if other is not link and (box := other.visual_box) is not None]
    return own is not None and bool(lengths) and (max(own.size) < median(lengths) / 2)

def geo_missing_collision__lacking(model):
    if not model.joints or all((link.has('collision') or not link.has('visual') for link in model.links)):
        return []
    if model.may_be_static:
        return []
    moving = [link for link in model.links if link.has('visual') and geo_missing_collision__moves(link)]
    bare = [link for link in moving if not link.has('collision') and (not link.misspells('collision'))]
    if not bare or len(bare) * 2 > len(moving):
        return []
    found = []
    for link in bare:
        alike = [other for other in link.counterparts or geo_missing_collision__numbered(link) if other in moving]
        complete = [other for other in alike if other.has('collision')]
        if len(complete) * 2 > len(alike):
            found.append((link, complete[0]))
        elif not alike and len(bare) == 1 and (len(moving) > geo_missing_collision__LEAST) and (not geo_missing_collision__is_small(link, moving)):
            found.append((link, None))
    return found

def GEO008_applies(model):
    return bool(geo_missing_collision__lacking(model))

def geo_exchanged_drive_sides__is_exchanged(plugin):
    drive = plugin.drive
    if drive is None or not drive.distance < 0:
        return False
    return sum((left * right for left, right in zip(drive.left.axis, drive.right.axis, strict=True))) > 0.5

def GEO009_applies(plugin):
    return geo_exchanged_drive_sides__is_exchanged(plugin)

def geo_opposed_drive_axes__is_opposed(plugin):
    drive = plugin.drive
    if drive is None:
        return False
    return sum((left * right for left, right in zip(drive.left.axis, drive.right.axis, strict=True))) < -0.5

def GEO010_applies(plugin):
    return geo_opposed_drive_axes__is_opposed(plugin)

geo_mismatched_wheel_separation__MOST = 0.1

def geo_mismatched_wheel_separation__is_mismatched(plugin):
    drive = plugin.drive
    if drive is None or drive.separation is None or (not drive.separation.own_value.number > 0):
        return False
    distance = abs(drive.distance)
    return distance > 0.01 and abs(drive.separation.own_value.number - distance) > geo_mismatched_wheel_separation__MOST * distance

def GEO011_applies(plugin):
    return geo_mismatched_wheel_separation__is_mismatched(plugin)

geo_mismatched_wheel_radius__ALIKE = 0.01

def geo_mismatched_wheel_radius__differ(plugin):
    drive = plugin.drive
    return drive is not None and abs(drive.left.radius - drive.right.radius) > geo_mismatched_wheel_radius__ALIKE * drive.left.radius

geo_mismatched_wheel_radius__MOST = 0.1

def geo_mismatched_wheel_radius__is_mismatched(plugin):
    drive = plugin.drive
    return drive is not None and abs(drive.written_radius - drive.left.radius) > geo_mismatched_wheel_radius__MOST * drive.left.radius

def GEO012_applies(plugin):
    return geo_mismatched_wheel_radius__differ(plugin) or geo_mismatched_wheel_radius__is_mismatched(plugin)

def geo_wheel_across_axis__is_endless(joint):
    low, high = joint.axis.limit.range
    return joint.type == 'continuous' or (low < -1000.0 and high > 1000.0)

geo_wheel_across_axis__SMALLEST = 0.005

def geo_wheel_across_axis__alignment(joint):
    link = joint.child_link if joint.type in {'continuous', 'revolute'} else None
    shapes = link.collisions or link.visuals if link is not None else ()
    if len(shapes) != 1 or shapes[0].geometry.shape != 'cylinder':
        return -1.0
    own = joint.find('pose')
    if joint.axis.expressed_in or not geo_wheel_across_axis__is_endless(joint) or (own is not None and own.content):
        return -1.0
    geometry, axis = (shapes[0].geometry, joint.axis.xyz)
    radius, length = (float(geometry.radius), float(geometry.length))
    if geometry.solid is None or not radius >= geo_wheel_across_axis__SMALLEST or (not length < 2 * radius):
        return -1.0
    way, place = (shapes[0].along, shapes[0].position)
    if way is None or place is None or math_dist(place, (0, 0, 0)) > 0.6 * radius or (not math_hypot(*axis) > 0) or (len(axis) != 3):
        return -1.0
    return abs(sum((one * other for one, other in zip(way, axis, strict=True)))) / math_hypot(*axis)

geo_wheel_across_axis__MOST = math_cos(math_radians(10))

def GEO013_applies(joint):
    return 0 <= geo_wheel_across_axis__alignment(joint) < geo_wheel_across_axis__MOST

geo_mismatched_heightmaps__NAMES = ('pos', 'size')

def geo_mismatched_heightmaps__numbers(value):
    try:
        return [float(word) for word in value.text.split()]
    except ValueError:
        return None

def geo_mismatched_heightmaps__pairs(link):
    seen = {shape.geometry.uri: shape.geometry.shape_element for shape in link.visuals if shape.geometry.shape == 'heightmap'}
    for shape in link.collisions:
        own, other = (shape.geometry.shape_element, seen.get(shape.geometry.uri))
        if own is None or other is None or shape.geometry.shape != 'heightmap':
            continue
        for name in geo_mismatched_heightmaps__NAMES:
            first, second = (own.value(name), other.value(name))
            if first is not None and second is not None and (geo_mismatched_heightmaps__numbers(first) != geo_mismatched_heightmaps__numbers(second)):
                yield (name, first, second)

def GEO014_applies(link):
    return any((True for _ in geo_mismatched_heightmaps__pairs(link)))

def inr_moments__is_remarkable(inertial):
    return not (inertial.is_unremarkable or inertial.is_automatic)

def inr_moments__has_moments_only(inertial):
    if not inertial.is_legible or not any(inertial.tensor):
        return False
    built = inertial.link.model.as_built_by(sdfcheck_.Consumer.GAZEBO)
    return built.base(inertial.link) in built.with_mass

def INR001_applies(inertial):
    if not inr_moments__is_remarkable(inertial):
        return False
    mass = inertial.mass
    if mass.number == 0:
        if inertial.link.may_be_static:
            return False
        return not inertial.is_urdf or inr_moments__has_moments_only(inertial)
    return mass.number < 0 or mass.text.lower() == 'nan'

def inr_moments__is_weighed(inertial):
    if not inertial.is_legible:
        return False
    mass = inertial.mass
    if mass.number == 0 and mass.is_given:
        return not inertial.is_urdf
    return not mass.is_given or mass.number > 0 or '$' in mass.text

def inr_moments__has_moments(inertial):
    return inr_moments__is_remarkable(inertial) and inr_moments__is_weighed(inertial)

def inr_moments__is_indefinite(inertial):
    return inertial.tensor.is_indefinite

def INR002_applies(inertial):
    return inr_moments__has_moments(inertial) and inr_moments__is_indefinite(inertial)

def inr_moments__is_impossible(inertial):
    return inertial.tensor.is_impossible

def INR003_applies(inertial):
    return inr_moments__has_moments(inertial) and inr_moments__is_impossible(inertial) and (not inr_moments__is_indefinite(inertial))

def INR004_applies(link):
    if link.has('inertial') or link.is_urdf or link.may_be_static:
        return False
    return (link.has('collision') or link.has('visual')) and (not link.misspells('inertial'))

def inr_moments__is_unit(inertial):
    return inertial.tensor == (1, 1, 1, 0, 0, 0)

def inr_moments__is_written(inertial):
    return inertial.is_given and (not inertial.is_automatic) and (not inertial.link.may_be_static)

inr_moments___FACTOR = 100.0

def inr_moments__is_out_of_scale(inertial):
    link = inertial.link
    if link.size_to_reach > inr_moments___FACTOR or link.size_to_reach < 1 / inr_moments___FACTOR:
        return True
    return link.holder is not None and link.holder.kind == 'model' and link.model.is_out_of_scale

def inr_moments__ratio(inertial):
    if inertial.is_near and (not inertial.link.has_mesh):
        return math_.nan
    if not inr_moments__is_written(inertial) or not inr_moments__is_weighed(inertial):
        return math_.nan
    if inr_moments__is_indefinite(inertial) or inr_moments__is_impossible(inertial):
        return math_.nan
    expected, trace = (inertial.solid_trace, inertial.tensor.trace)
    found = trace / expected if 0 < expected < math_.inf and 0 < trace < math_.inf else math_.nan
    return math_.nan if (found > inr_moments___FACTOR or found < 1 / inr_moments___FACTOR) and inr_moments__is_out_of_scale(inertial) else found

inr_moments___LITTLE, inr_moments___EXACTLY = (2.0, 0.05)

inr_moments___LITTLE, inr_moments___EXACTLY = (2.0, 0.05)

def inr_moments__is_about_origin(inertial):
    if inertial.is_near and (not inertial.link.has_mesh):
        return False
    if not any(inertial.center or ()) or inertial.inertia is None or inertial.center is None:
        return False
    found = inr_moments__ratio(inertial)
    if not found > inr_moments___LITTLE:
        return False
    offset = math_.hypot(*inertial.center)
    shifted = (inertial.tensor.trace - 2 * inertial.mass.number * offset * offset) / inertial.solid_trace
    if not offset > 0:
        return False
    return 1 / 3 < shifted < 3 if found > 10 else bool(inertial.link.solids) and abs(shifted - 1) < inr_moments___EXACTLY

def inr_moments__is_far_off(inertial):
    if inertial.is_unremarkable and (not inertial.link.has_mesh):
        return False
    found = inr_moments__ratio(inertial)
    return (found < 1 / inr_moments___FACTOR or found > inr_moments___FACTOR) and (not inr_moments__is_about_origin(inertial))

def inr_moments__most(inertial):
    box = inertial.link.extent
    if box is None:
        return ()
    x, y, z = (length * length for length in box.size)
    return tuple((inertial.mass.number / 4 * square for square in (y + z, x + z, x + y)))

def inr_moments__is_too_large(inertial):
    if not inr_moments__is_written(inertial) or not 0 < inertial.mass.number != 1 or inr_moments__is_out_of_scale(inertial):
        return False
    return any((moment > bound for moment, bound in zip(inertial.tensor[:3], inr_moments__most(inertial), strict=False)))

def INR005_applies(inertial):
    return inr_moments__is_unit(inertial) and (inr_moments__is_far_off(inertial) or inr_moments__is_too_large(inertial))

def INR006_applies(inertial):
    return inr_moments__is_far_off(inertial) and inertial.inertia is not None and (not inr_moments__is_unit(inertial))

def INR007_applies(inertial):
    return inr_moments__is_about_origin(inertial)

def inr_unusable_automatic_inertia___has_no_mass(density):
    return density.number <= 0

def inr_unusable_automatic_inertia___density(inertial, collision):
    return collision.density if collision.density.is_given else inertial.density

inr_unusable_automatic_inertia___NO_SOLID = frozenset({'', 'plane', 'heightmap', 'polyline', 'image', 'empty'})

def INR008_applies(inertial):
    if inertial.is_unremarkable or not inertial.is_automatic or inertial.link.may_be_static:
        return False
    collisions = inertial.link.collisions
    return not collisions or any((inr_unusable_automatic_inertia___has_no_mass(inr_unusable_automatic_inertia___density(inertial, collision)) or collision.geometry.shape in inr_unusable_automatic_inertia___NO_SOLID for collision in collisions))

def INR009_applies(inertial):
    if inertial.link.may_be_static or not inr_moments__has_moments(inertial) or inertial.inertia is None or any(inertial.tensor):
        return False
    if not (inertial.mass.is_given and inertial.mass.number > 0):
        return False
    link = inertial.link
    if link.parent_joints:
        return bool(link.shapes) and link.parent_joints[0].moves
    if link.child_joints or link in inertial.root.parent_joints:
        return False
    return not any((link.name in {joint.parent_name, joint.child_name} for joint in inertial.root.each(sdfcheck_.Joint)))

inr_oversized_inertia__LEAST = 1e-06

inr_oversized_inertia__MOST = 20.0

def INR010_applies(inertial):
    if inertial.is_unremarkable or inertial.inertia is None:
        return False
    if not inertial.is_given or not inr_oversized_inertia__LEAST < inertial.mass.number < math_inf:
        return False
    largest = max(inertial.tensor[:3])
    if not inr_oversized_inertia__MOST * inr_oversized_inertia__MOST * inertial.mass < largest < math_inf:
        return False
    return not inertial.link.shapes and (not inertial.link.may_be_static)

def inr_distant_center_of_mass__distance(inertial):
    return math_hypot(*(inertial.center or (0.0, 0.0, 0.0)))

inr_distant_center_of_mass__MOST = 10.0

def INR011_applies(inertial):
    if inertial.is_unremarkable or not (inertial.has('pose') or inertial.has('origin')):
        return False
    return inr_distant_center_of_mass__distance(inertial) > inr_distant_center_of_mass__MOST and (not inertial.link.may_be_static) and (inertial.link.extent is None)

inr_negative_added_mass__DIAGONAL = ('xx', 'yy', 'zz', 'pp', 'qq', 'rr')

def inr_negative_added_mass__negative(inertial):
    added = inertial.find('fluid_added_mass')
    for name in () if added is None else inr_negative_added_mass__DIAGONAL:
        value = added.value(name) if added is not None else None
        if value is not None and value.number < 0:
            yield value

def INR012_applies(inertial):
    return not inertial.is_unremarkable and inertial.has('fluid_added_mass') and any(inr_negative_added_mass__negative(inertial))

inr_places___LEAST = 0.001

def inr_places__is_compared(inertial):
    if inertial.is_inside and (not inertial.link.has_mesh):
        return False
    if not inr_moments__is_written(inertial) or not inertial.mass.number >= inr_places___LEAST or inertial.center is None:
        return False
    return inertial.link.extent is not None

inr_places___MARK = 0.015

def inr_places__outside(inertial):
    center, link = (inertial.center, inertial.link)
    if center is None or not inr_places__is_compared(inertial) or link.extent is None or (not link.extent.distance_to(center)):
        return 0.0
    box = link.fixed_extent
    if box is None or not max(box.size) > inr_places___MARK or inr_moments__is_out_of_scale(inertial):
        return 0.0
    return box.distance_to(center) / max(box.size)

inr_center_outside_link__MOST = 0.7

def inr_places__place_of(inertial):
    place = inertial.find('origin' if inertial.is_urdf else 'pose')
    value = None if place is None else place.attribute('xyz') if inertial.is_urdf else place.own_value
    return value if value is not None and value.text.strip() else None

inr_places___APART, inr_places___AT_END = (0.4, 0.49)

inr_places___APART, inr_places___AT_END = (0.4, 0.49)

def inr_places__is_off_origin(inertial):
    if not inr_places__is_compared(inertial) or any(inertial.center or ()):
        return False
    if inr_places__place_of(inertial) is not None and inertial.link.has_mesh:
        return False
    apart = inr_places___APART if inr_places__place_of(inertial) is None else inr_places___AT_END
    for name in ('extent', 'fixed_extent'):
        box = getattr(inertial.link, name)
        if box is None or not max(box.size) > inr_places___MARK:
            return False
        if not any((abs(at) > apart * size > 0 for at, size in zip(box.center, box.size, strict=True))):
            return False
    return not inr_moments__is_out_of_scale(inertial)

def INR013_applies(inertial):
    return inr_places__outside(inertial) > inr_center_outside_link__MOST and (not inr_places__is_off_origin(inertial))

def INR014_applies(inertial):
    return inr_places__is_off_origin(inertial)

def inr_moments__is_doubtful(inertial):
    return (not inertial.fits_shapes or inertial.link.has_mesh) and inr_moments__is_written(inertial)

def inr_exchanged_moments__is_turned(part):
    place = part.find('origin' if part.is_urdf else 'pose')
    if place is None:
        return False
    words = place.text_of('rpy') or '' if part.is_urdf else ' '.join(place.content.split()[3:])
    return any((word.strip('+-0.') for word in words.split())) or place.text_of('quat_xyzw') is not None

inr_exchanged_moments__FITS, inr_exchanged_moments__DIFFERS = (1.5, 2.2)

inr_exchanged_moments__FITS, inr_exchanged_moments__DIFFERS = (1.5, 2.2)

def inr_exchanged_moments__off(moments, others):
    return max((max(one / other, other / one) for one, other in zip(moments, others, strict=True)))

inr_exchanged_moments__PAIRS = ((1, 2), (0, 1), (0, 2))

def inr_exchanged_moments__of_another_body(inertial):
    moments, box = (inertial.tensor[:3], inertial.link.box)
    if box is None or max(moments) < inr_exchanged_moments__DIFFERS / inr_exchanged_moments__FITS * min(moments):
        return ()
    squares = [length * length for length in box.size]
    solid = [inertial.mass.number / 12 * (sum(squares) - square) for square in squares]
    if not min(solid) > 0 or inr_exchanged_moments__off(moments, solid) <= inr_exchanged_moments__DIFFERS:
        return ()
    for first, second in inr_exchanged_moments__PAIRS:
        turned = list(moments)
        turned[first], turned[second] = (turned[second], turned[first])
        if inr_exchanged_moments__off(turned, solid) <= inr_exchanged_moments__FITS:
            return (first, second)
    return ()

inr_exchanged_moments__NEAR, inr_exchanged_moments__EXACT, inr_exchanged_moments__ROUNDED = (0.05, 0.125, 0.002)

inr_exchanged_moments__NEAR, inr_exchanged_moments__EXACT, inr_exchanged_moments__ROUNDED = (0.05, 0.125, 0.002)

inr_exchanged_moments__NEAR, inr_exchanged_moments__EXACT, inr_exchanged_moments__ROUNDED = (0.05, 0.125, 0.002)

def inr_exchanged_moments__of_other_axes(inertial):
    moments, solids = (inertial.tensor[:3], inertial.link.solids)
    only = solids[0].geometry.solid if len(solids) == 1 and (not inr_exchanged_moments__is_turned(solids[0])) else None
    if only is None or not min(only.moments[:3]) > 0:
        return ()
    solid = [inertial.mass.number * moment for moment in only.moments[:3]]
    for first, second in inr_exchanged_moments__PAIRS:
        turned = list(moments)
        turned[first], turned[second] = (turned[second], turned[first])
        as_written = abs(moments[first] * solid[second] / moments[second] / solid[first] - 1)
        exchanged_back = abs(turned[first] * solid[second] / turned[second] / solid[first] - 1)
        if as_written > inr_exchanged_moments__ROUNDED and exchanged_back < inr_exchanged_moments__EXACT * as_written and (inr_exchanged_moments__off(turned, solid) < 1 + inr_exchanged_moments__NEAR):
            return (first, second)
    return ()

def inr_exchanged_moments__exchanged(inertial):
    if not inr_moments__is_doubtful(inertial) or not inr_moments__is_weighed(inertial) or inr_exchanged_moments__is_turned(inertial):
        return ()
    moments, mass = (inertial.tensor, inertial.mass.number)
    if not mass > 0 or not min(moments[:3]) > 0 or max(map(abs, moments[3:])) > min(moments[:3]) / 10:
        return ()
    if inertial.link.extent is None or not all((moment.is_given for moment in list(inertial.moments.values())[:3])):
        return ()
    return inr_exchanged_moments__of_another_body(inertial) or inr_exchanged_moments__of_other_axes(inertial)

def INR015_applies(inertial):
    return bool(inr_exchanged_moments__exchanged(inertial))

def inr_excess_density__density(inertial):
    box = inertial.link.extent if inr_moments__is_doubtful(inertial) else None
    volume = math_prod(box.size) if box is not None else 0.0
    return inertial.mass.number / volume if volume > 0 else 0.0

inr_excess_density__HEAVIEST = 25000.0

inr_excess_density__LEAST = 0.2

inr_excess_density__BEYOND = 100000.0

inr_excess_density__HEAVIER = 20.0

def inr_excess_density__is_too_dense(inertial):
    if not inertial.mass.is_given or (inertial.is_light and (not inertial.link.has_mesh)):
        return False
    link = inertial.link
    if link.holder is not None and link.holder.kind == 'model' and link.model.joints and (not link.parent_joints):
        return False
    mass, found = (inertial.mass.number, inr_excess_density__density(inertial))
    if not found > inr_excess_density__HEAVIEST or not mass >= inr_excess_density__LEAST or any((joint.is_fixed for joint in inertial.link.parent_joints)):
        return False
    if inr_moments__is_out_of_scale(inertial):
        return False
    if found > inr_excess_density__BEYOND:
        return True
    from statistics import median
    others = [link.inertial.mass.number for link in inertial.link.model.links if link is not inertial.link]
    known = [other for other in others if other > 0]
    return len(known) > 1 and mass > inr_excess_density__HEAVIER * median(known)

def INR016_applies(inertial):
    return inr_excess_density__is_too_dense(inertial)

def inr_shapes_without_mass__weight(link):
    if link.has('inertial') or not link.has('collision') or link.misspells('inertial'):
        return None
    if not any((joint.moves for joint in link.parent_joints)):
        return None
    tied = [joint.child_link for joint in link.child_joints if joint.is_fixed]
    weighed = [other for other in tied if other is not None and other.has_mass]
    return weighed[0] if weighed and all((other.shapes for other in weighed)) else None

def INR017_applies(link):
    return inr_shapes_without_mass__weight(link) is not None

def jnt_unknown_joint_end___joint_name(end):
    joint = end.element.parent
    return '' if joint is None else joint.attributes.get('name', '').strip()

def jnt_unknown_joint_end___unknown_ends(joint):
    if joint.parent is not None and joint.child is not None:
        return []
    parent, child = (joint.parent_value, joint.child_value)
    unknown = [parent] if parent is not None and joint.parent is None else []
    unknown += [child] if child is not None and joint.child is None else []
    if not unknown:
        return []
    scope = joint.scope
    found = []
    for value in unknown:
        ends = scope.unresolved.get(value.text)
        if ends is None or value.text in scope.lost_names:
            continue
        if not joint.is_urdf:
            if value.text == joint.name:
                found.append((value, []))
                continue
            ends = [end for end in ends if jnt_unknown_joint_end___joint_name(end) != value.text]
        if ends[0].element is value.element:
            found.append((value, ends[1:]))
    return found

def JNT001_applies(joint):
    return bool(jnt_unknown_joint_end___unknown_ends(joint))

def JNT002_applies(joint):
    child, parent = (joint.child_value, joint.parent_value)
    if child is None or parent is None:
        return False
    if child.text == parent.text:
        return joint.is_urdf or child.text != 'world'
    return joint.child_link is not None and joint.child_link is joint.parent_link

def JNT003_applies(joint):
    if joint.parent_value is None or joint.child_value is None:
        return False
    if joint.is_urdf:
        is_link = joint.child_name == 'world' and joint.child is not None
        return is_link and joint.parent_name != 'world'
    if joint.child_name == 'world':
        return True
    child = joint.child
    carrier = None if child is None or joint.parent is None else child.carrier
    return carrier is not None and carrier.kind == 'world'

def JNT004_applies(joint):
    return not joint.is_urdf and any((not axis.is_given and (not joint.misspells(name)) for axis, name in zip(joint.axes, ('axis', 'axis2'), strict=False)))

jnt_inverted_limits__BOUNDED = frozenset(('prismatic', 'revolute'))

def JNT005_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not lower > upper or not lower.number > upper.number or (not (lower.is_given and upper.is_given)):
        return False
    if limit.is_urdf and (not (limit.joint.type in jnt_inverted_limits__BOUNDED and math_inf > lower.number and (upper.number > -math_inf))):
        return False
    return limit.axis.limit is limit

jnt_directions__NO_LENGTH = 1e-06

def jnt_directions__has_no_length(axis):
    return axis.length <= 0 if axis.is_urdf else axis.length < jnt_directions__NO_LENGTH

jnt_directions__WITH_AXIS = frozenset(('continuous', 'planar', 'prismatic', 'revolute'))

def jnt_directions__is_used(axis):
    joint = axis.joint
    if axis is not joint.axis and axis is not joint.axis2:
        return False
    return not axis.is_urdf or joint.type in jnt_directions__WITH_AXIS

def JNT006_applies(axis):
    return jnt_directions__has_no_length(axis) and jnt_directions__is_used(axis)

def JNT007_applies(root):
    return any((not joint.is_urdf or joint.name != joints[0].name for joints in root.parent_joints.values() for joint in joints[1:]))

def JNT008_applies(root):
    return bool(root.loops)

def JNT009_applies(mimic):
    value, joint = (mimic.leader_value, mimic.joint)
    if value is None or mimic is not mimic.axis.mimic:
        return False
    if mimic.leader is not None:
        return mimic.is_without_axis
    if mimic.is_urdf:
        return not joint.is_fixed
    name, scope = (mimic.leader_name, joint.scope)
    return scope.resolve(name) is not None or not ('' in name.split('::') or scope.may_hold(name))

jnt_negative_limit__NO_LIMIT = (-1.0, -math_inf)

def jnt_negative_limit___negative(part):
    is_limit = part.kind == 'limit'
    names = ('effort', 'velocity') if is_limit else ('damping', 'friction')
    numbers = [getattr(part, name) for name in names]
    if min(numbers) >= 0 or (is_limit and part.is_urdf and (not part.joint.moves)):
        return []
    exempt = jnt_negative_limit__NO_LIMIT if is_limit else ()
    below = zip(names, numbers, strict=True)
    return [(name, number) for name, number in below if number.number < 0 and number.number not in exempt]

def JNT010_applies(part):
    if not jnt_negative_limit___negative(part):
        return False
    return part is part.axis.limit or part is part.axis.dynamics

jnt_useless_limit__ENDLESS_TYPES = frozenset(('continuous', 'floating', 'planar'))

jnt_useless_limit__ROUNDING = 0.001

jnt_useless_limit__UNLIMITED = 1000000000000000.0

def jnt_useless_limit___useless(limit):
    if limit.joint.type not in jnt_useless_limit__ENDLESS_TYPES:
        return []
    lower, upper = (limit.lower, limit.upper)
    if limit.is_urdf:
        if lower.is_given and upper.is_given and (upper.number - lower.number > 2 * math_pi - jnt_useless_limit__ROUNDING):
            return []
        return [value for value in (lower, upper) if value.is_given and abs(value.number) > 0]
    if lower.number > upper.number:
        return []
    return [value for value in (lower, upper) if value.is_given and abs(value.number) < jnt_useless_limit__UNLIMITED]

def JNT011_applies(limit):
    return bool(jnt_useless_limit___useless(limit)) and limit.axis.limit is limit

def jnt_mimic_cycle___rings(root):
    found = []
    done = set()
    for start in root.each('Mimic'):
        path = {}
        at = start
        while at is not None and at not in path and (at not in done):
            path[at] = None
            at = at.next
        if at in path:
            members = list(path)
            found.append(members[members.index(at):])
        done.update(path)
    return found

def JNT012_applies(root):
    return bool(jnt_mimic_cycle___rings(root))

jnt_non_unit_axis__ROUNDING = 0.001

def JNT013_applies(axis):
    return abs(axis.length - 1) > jnt_non_unit_axis__ROUNDING and (not jnt_directions__has_no_length(axis)) and jnt_directions__is_used(axis)

jnt_limits_in_degrees__LEAST, jnt_limits_in_degrees__MOST = (20.0, 720.0)

jnt_limits_in_degrees__LEAST, jnt_limits_in_degrees__MOST = (20.0, 720.0)

jnt_limits_in_degrees__TURNING = frozenset({'revolute', 'revolute2', 'universal'})

jnt_limits_in_degrees__ROUND = 30.0

jnt_limits_in_degrees__LITTLE = 3.0

def JNT014_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not (lower.is_given and upper.is_given and (jnt_limits_in_degrees__LEAST <= max(-lower, upper) <= jnt_limits_in_degrees__MOST)):
        return False
    if limit.joint.type not in jnt_limits_in_degrees__TURNING or -lower > jnt_limits_in_degrees__MOST or limit.axis.limit is not limit:
        return False
    if lower.number % 1 == 0 == upper.number % 1:
        return max(-lower, upper) >= jnt_limits_in_degrees__ROUND
    return all((not 0 < abs(end) < jnt_limits_in_degrees__LITTLE for end in (lower.number, upper.number)))

jnt_missing_upper_limit__BOUNDED = frozenset({'revolute', 'prismatic'})

def jnt_missing_upper_limit__is_missed(limit):
    is_endless = limit.range[0] == -float('inf')
    is_bounded = not limit.is_urdf or limit.joint.type in jnt_missing_upper_limit__BOUNDED
    return is_bounded and (not is_endless) and limit.lacks('upper') and (limit.axis.limit is limit)

def JNT015_applies(limit):
    if not limit.lower.is_given or limit.upper.is_given or limit.has('upper'):
        return False
    return jnt_missing_upper_limit__is_missed(limit)

def jnt_zero_limit__zeros(limit):
    if limit.effort and limit.velocity:
        return {}
    limits = {'effort': limit.effort, 'velocity': limit.velocity}
    return {name: number for name, number in limits.items() if number.is_given and number.number == 0}

def JNT016_applies(limit):
    if not jnt_zero_limit__zeros(limit) or not limit.joint.moves:
        return False
    is_locked = limit.lower == limit.upper and limit.range[0] == limit.range[1]
    return not is_locked and limit.axis.limit is limit

jnt_swapped_soft_limits__SLACK = 0.001

jnt_swapped_soft_limits__FAR = 1.0

def jnt_swapped_soft_limits__faults(controller):
    lower, upper = (controller.attribute(name) for name in ('soft_lower_limit', 'soft_upper_limit'))
    if lower is not None and upper is not None and (lower.number > upper.number):
        yield (lower, upper, f'lower soft limit {lower.text} is above upper soft limit {upper.text}')
        return
    joint = controller.parent
    limit = joint.find('limit') if joint is not None and joint.get('type') in {'revolute', 'prismatic'} else None
    if limit is None:
        return
    outside = []
    for soft, name, sign in ((lower, 'lower', -1), (upper, 'upper', 1)):
        hard = limit.attribute(name)
        excess = sign * (soft.number - hard.number) if soft is not None and hard is not None else 0.0
        if soft is not None and hard is not None and (excess > jnt_swapped_soft_limits__SLACK):
            message = f'{name} soft limit {soft.text} is outside of the limit {hard.text}'
            outside.append((soft, hard, message, excess))
    if len(outside) < 2 or min((excess for *_, excess in outside)) < jnt_swapped_soft_limits__FAR:
        yield from (found[:3] for found in outside)

def JNT017_applies(controller):
    return next(jnt_swapped_soft_limits__faults(controller), None) is not None

def JNT018_applies(joint):
    name = joint.get('gearbox_reference_body') if joint.type == 'gearbox' else None
    return name is not None and name.strip() != '' and joint.scope.lacks(name.strip())

def jnt_zero_ratio__zeros(joint):
    if joint.type == 'gearbox':
        found = {'gearbox_ratio': joint.gearbox_ratio}
    else:
        found = {'screw_thread_pitch': joint.screw_thread_pitch, 'thread_pitch': joint.thread_pitch}
    return {name: number for name, number in found.items() if number.is_given and number.number == 0}

def JNT019_applies(joint):
    return joint.type in {'gearbox', 'screw'} and bool(jnt_zero_ratio__zeros(joint))

def jnt_asymmetric_joint__place(joint):
    origin = joint.find('origin')
    text = '0 0 0' if origin is None else origin.text_of('xyz', '0 0 0')
    try:
        return sorted((abs(float(word)) for word in text.split()))
    except ValueError:
        return []

jnt_asymmetric_joint__LEAST, jnt_asymmetric_joint__SHARE = (0.005, 0.05)

jnt_asymmetric_joint__LEAST, jnt_asymmetric_joint__SHARE = (0.005, 0.05)

def jnt_asymmetric_joint__displacement(joint, mirror):
    own, other = (jnt_asymmetric_joint__place(joint), jnt_asymmetric_joint__place(mirror))
    if len(own) != 3 or len(other) != 3:
        return 0.0
    found = math_dist(own, other)
    return found if found > max(jnt_asymmetric_joint__LEAST, jnt_asymmetric_joint__SHARE * max(math_hypot(*own), math_hypot(*other))) else 0.0

jnt_asymmetric_joint__MOST = 3

def jnt_asymmetric_joint__displaced(model):
    pairs = [(joint, mirror) for joint in model.joints if joint.moves and (mirror := joint.mirror) is not None]
    found = [(joint, mirror) for joint, mirror in pairs if mirror.moves and joint.span.start > mirror.span.start and (jnt_asymmetric_joint__displacement(joint, mirror) > 0)]
    return found if len(found) <= jnt_asymmetric_joint__MOST else []

def JNT020_applies(model):
    return bool(jnt_asymmetric_joint__displaced(model))

jnt_opposed_axis__LEAST = 3

def jnt_opposed_axis__turns(joint):
    origin = joint.find('origin')
    return (joint.type, '' if origin is None else ' '.join(origin.text_of('rpy', '0 0 0').split()))

def jnt_opposed_axis__is_opposed(joint):
    if not joint.moves or len((others := joint.counterparts)) < jnt_opposed_axis__LEAST:
        return False
    if not joint.axis.xyz.is_given or len(joint.axis.xyz) != 3 or jnt_opposed_axis__turns(joint) != jnt_opposed_axis__turns(others[0]):
        return False
    first = tuple(others[0].axis.xyz)
    if any((tuple(other.axis.xyz) != first or jnt_opposed_axis__turns(other) != jnt_opposed_axis__turns(joint) for other in others[1:])):
        return False
    return any(first) and tuple((-number for number in joint.axis.xyz)) == first

def JNT021_applies(joint):
    return jnt_opposed_axis__is_opposed(joint)

jnt_mimic_beyond_limits__SHARE = 0.05

def jnt_mimic_beyond_limits__span(mimic):
    leader, joint = (mimic.leader, mimic.joint)
    if leader is None or joint.is_fixed or leader.is_fixed or (leader.axis.mimic is not None):
        return None
    low, high = leader.axis.limit.range
    own_low, own_high = joint.axis.limit.range
    if not -math_inf < low < high < math_inf or not own_low < own_high:
        return None
    ends = sorted((float(mimic.multiplier) * end + float(mimic.offset) for end in (low, high)))
    room = jnt_mimic_beyond_limits__SHARE * (ends[1] - ends[0])
    return (ends[0], ends[1]) if ends[0] < own_low - room or ends[1] > own_high + room else None

def JNT022_applies(mimic):
    return jnt_mimic_beyond_limits__span(mimic) is not None

def JNT023_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not (lower.is_given and upper.is_given and (lower.number == upper.number != 0)):
        return False
    return limit.joint.type in jnt_inverted_limits__BOUNDED and limit.axis.limit is limit

def muj_meshes__compiler(model):
    found = {}
    for extension in model.children('mujoco'):
        for settings in extension.children('compiler'):
            found |= settings.attributes
    return found

def muj_meshes__mesh_files(model):
    settings = muj_meshes__compiler(model)
    kinds = ('collision', 'visual') if settings.get('discardvisual') == 'false' else ('collision',)
    for link in model.links:
        for shape in link.shapes:
            value = shape.geometry.uri_value
            if value is None or shape.kind not in kinds or shape.geometry.shape != 'mesh':
                continue
            if '${' not in value.text and '$(' not in value.text:
                yield value

def muj_unopened_mesh___by_scheme(model):
    found = {}
    if not model.is_urdf or muj_meshes__compiler(model).get('strippath') == 'true':
        return found
    for value in muj_meshes__mesh_files(model):
        scheme, delimiter, _ = value.text.strip().partition(':/')
        if delimiter:
            found.setdefault(scheme, []).append(value)
    return found

def MUJ001_applies(model):
    return bool(muj_unopened_mesh___by_scheme(model))

muj_undecoded_mesh__DECODED = frozenset(('.msh', '.obj', '.stl'))

def muj_undecoded_mesh___by_suffix(model):
    found = {}
    for value in muj_meshes__mesh_files(model) if model.is_urdf else ():
        suffix = pathlib_PurePosixPath(value.text.strip()).suffix.lower()
        if suffix not in muj_undecoded_mesh__DECODED:
            found.setdefault(suffix, []).append(value)
    return found

def MUJ002_applies(model):
    return bool(muj_undecoded_mesh___by_suffix(model))

muj_mass__LEAST = 1e-15

def muj_mass___has_mass(link):
    inertial = link.inertial
    if not inertial.is_given:
        return link.has('collision')
    if not inertial.has('mass') or not inertial.has('inertia'):
        return True
    numbers = [inertial.mass, *(inertial.moments[moment] for moment in ('ixx', 'iyy', 'izz'))]
    return not any((number.is_given and number.number <= muj_mass__LEAST for number in numbers))

def muj_mass___fused(link):
    found = {link}
    waiting = [link]
    while waiting:
        for joint in waiting.pop().child_joints:
            child = joint.child_link if joint.is_fixed else None
            if child is not None and child not in found:
                found.add(child)
                waiting.append(child)
    return found

def muj_mass__is_massless(link):
    joints = link.parent_joints
    return bool(joints) and joints[0].moves and (not any(map(muj_mass___has_mass, muj_mass___fused(link))))

def MUJ003_applies(link):
    return link.is_urdf and muj_mass__is_massless(link)

muj_singular_inertia__LEAST = 1e-14

def MUJ004_applies(inertial):
    if not inertial.is_urdf or inertial.inertia is None or (not inertial.is_legible):
        return False
    low, _, high = inertial.principal
    if low >= muj_singular_inertia__LEAST or high <= 0 or inertial.tensor.is_indefinite or inertial.tensor.is_impossible:
        return False
    return not muj_mass__is_massless(inertial.link)

def muj_fused_root__is_kept(link):
    compilers = (each for block in link.model.children('mujoco') for each in block.children('compiler'))
    return any((each.attributes.get('fusestatic', '').strip().lower() == 'false' for each in compilers))

def MUJ005_applies(link):
    if not link.is_urdf or link.name == 'world' or (not link.has_mass) or (not link.child_joints):
        return False
    return link in link.model.tree.main_roots and (not muj_fused_root__is_kept(link))

def NAM001_applies(root):
    return any((first.kind == later.kind for first, later in root.names.shared))

def NAM002_applies(root):
    return any((first.kind != later.kind for first, later in root.names.shared))

nam_reserved_name___ROOT = '__root__'

def nam_reserved_name___is_reserved(name, root):
    text = name.name
    is_word = text == 'world' and (not (root.is_urdf and name.kind == 'link'))
    is_framed = len(text) >= 4 and text.startswith('__') and text.endswith('__')
    return (is_word or is_framed) and name.is_compared

def NAM003_applies(root):
    is_referred_to = nam_reserved_name___ROOT in root.document.source.text
    return is_referred_to or any((nam_reserved_name___is_reserved(name, root) for name in root.names.special))

def nam_delimiter_in_name___is_divided(name):
    is_free = ':' in name.kind or name.kind == 'material' or name.is_extension
    return '::' in name.name and (not is_free)

def NAM004_applies(root):
    return any(map(nam_delimiter_in_name___is_divided, root.names.special))

nam_malformed_scoped_name___ENDS = frozenset('"\'<>: \t\r\n')

def nam_malformed_scoped_name___may_be_odd(text):
    return any((text[match.start() - 1] in nam_malformed_scoped_name___ENDS or text[match.end():match.end() + 1] in nam_malformed_scoped_name___ENDS for match in re_.finditer('::', text)))

def nam_malformed_scoped_name___is_odd(reference):
    return '::' in reference.text and '' in reference.text.strip().split('::')

def NAM005_applies(root):
    return nam_malformed_scoped_name___may_be_odd(root.document.source.text) and any(map(nam_malformed_scoped_name___is_odd, root.names.references))

def nam_blank_around_name___is_standard(name):
    return ':' not in name.kind

def NAM007_applies(root):
    return any(map(nam_blank_around_name___is_standard, root.names.padded))

def NS003_applies(prefix):
    return bool(prefix.undeclared) and (prefix.name != 'xacro' or prefix.document.kind.value != 'xacro')

def NS004_applies(declaration):
    return declaration.first is not None

def NS005_applies(declaration):
    return declaration.name == 'xmlns' and declaration.document.kind.value == 'sdf'

def ns_prefix_declared_below_root___below(prefix):
    below = [each for each in prefix.declarations if each.is_used and (not each.is_on_root)]
    return [] if any((each.is_repeated for each in prefix.declarations)) else below

def NS006_applies(prefix):
    return not prefix.undeclared and bool(ns_prefix_declared_below_root___below(prefix))

def ns_soundness__is_malformed(name):
    prefix, _, local = name.partition(':')
    return not prefix or not local or ':' in local

ns_soundness__XML_NAMESPACE = 'http://www.w3.org/XML/1998/namespace'

ns_soundness__XMLNS_NAMESPACE = 'http://www.w3.org/2000/xmlns/'

def ns_soundness__is_reserved(declaration):
    if declaration.prefix == 'xml':
        return declaration.namespace != ns_soundness__XML_NAMESPACE
    return declaration.prefix == 'xmlns' or declaration.namespace in {ns_soundness__XML_NAMESPACE, ns_soundness__XMLNS_NAMESPACE}

def ns_soundness__is_sound(declaration):
    if ns_soundness__is_malformed(declaration.name) or declaration.first is not None:
        return False
    return bool(declaration.namespace.strip()) and (not ns_soundness__is_reserved(declaration))

def ns_unused_prefix___unused(declaration):
    return [each for each in declaration.beside if not each.is_used and ns_soundness__is_sound(each)]

def NS007_applies(declaration):
    if declaration.is_used or declaration.document.kind.value == 'xacro':
        return False
    return ns_unused_prefix___unused(declaration)[:1] == [declaration]

def NS008_applies(named):
    if isinstance(named, sdfcheck_.PrefixedName):
        return ns_soundness__is_malformed(named.name) and (not named.is_in_plugin)
    return ns_soundness__is_malformed(named.name) and named.name != 'xmlns'

def NS009_applies(custom):
    return bool(custom.displaced)

def NS010_applies(custom):
    return bool(custom.replaced)

def NS011_applies(declaration):
    outer = declaration.outer
    is_rival = declaration.twin is not None if outer is None else outer.namespace != declaration.namespace
    return is_rival and ns_soundness__is_sound(declaration)

def NS012_applies(declaration):
    if declaration.namespace.strip() or ns_soundness__is_malformed(declaration.name):
        return False
    return declaration.first is None and (not ns_soundness__is_reserved(declaration))

def NS013_applies(named):
    if ns_soundness__is_malformed(named.name):
        return False
    if isinstance(named, sdfcheck_.PrefixedName):
        return named.prefix == 'xmlns'
    return ns_soundness__is_reserved(named) and named.first is None

def NS014_applies(named):
    return named.first is not None

def R2C001_applies(block):
    return any((True for _ in block.lacking))

r2c_unknown_control_type__TYPES = ('actuator', 'sensor', 'system')

def R2C002_applies(block):
    return block.type_value is not None and block.type.strip() not in r2c_unknown_control_type__TYPES and ('$' not in block.type)

def R2C003_applies(block):
    return block.first_of_name is not None

def R2C004_applies(block):
    return block.has('ros2_control')

def R2C005_applies(block):
    return any((holder is block.element for _, holder, _ in block.foreign))

def R2C006_applies(block):
    return any((holder is not block.element and ':' not in child.name for child, holder, _ in block.foreign))

def R2C007_applies(block):
    return any((True for _ in block.without_plugin))

def R2C008_applies(block):
    plugin = block.plugin_value
    return plugin is not None and '::' in plugin.text and ('/' not in plugin.text) and ('$' not in plugin.text)

def r2c_unknown_control_plugin__has_blank(plugin):
    text = plugin.element.text or ''
    return len(text.split()) > 1 or text != text.strip()

r2c_unknown_control_plugin__KNOWN = ('fake_components/GenericSystem', 'gazebo_ros2_control/GazeboSystem', 'gz_ros2_control/GazeboSimSystem', 'ign_ros2_control/IgnitionSystem', 'joint_state_topic_hardware_interface/JointStateTopicSystem', 'mock_components/GenericSystem', 'mujoco_ros2_control/MujocoSystem', 'topic_based_ros2_control/TopicBasedSystem')

r2c_unknown_control_plugin__OWNERS = {'fake_components': 'fake_components/GenericSystem', 'gz_ros2_control': 'gz_ros2_control/GazeboSimSystem', 'ign_ros2_control': 'ign_ros2_control/IgnitionSystem', 'mock_components': 'mock_components/GenericSystem'}

def r2c_unknown_control_plugin__meant(plugin):
    return sdfcheck_.suggest(plugin, r2c_unknown_control_plugin__KNOWN) or r2c_unknown_control_plugin__OWNERS.get(plugin.partition('/')[0])

def R2C009_applies(block):
    plugin = block.plugin_value
    if plugin is None or '/' not in plugin.text or '$' in plugin.text:
        return False
    return r2c_unknown_control_plugin__has_blank(plugin) or (plugin.text not in r2c_unknown_control_plugin__KNOWN and r2c_unknown_control_plugin__meant(plugin.text) is not None)

r2c_obsolete_control_plugin__NOW = {'fake_components/GenericSystem': ('mock_components/GenericSystem', 'gone from jazzy on', sdfcheck_.Severity.WARNING), 'ign_ros2_control/IgnitionSystem': ('gz_ros2_control/GazeboSimSystem', 'an old name from iron on', sdfcheck_.Severity.INFO)}

def R2C010_applies(block):
    plugin = block.plugin_value
    return plugin is not None and plugin.text in r2c_obsolete_control_plugin__NOW

def R2C011_applies(component):
    joint = component.joint
    return joint is not None and joint.type in {'fixed', 'floating', 'planar'}

def R2C012_applies(component):
    return component.earlier is not None

def R2C013_applies(interface):
    return interface.twin is not None

def R2C014_applies(component):
    return component.what == 'joint' and any((True for _ in component.rivals))

def R2C015_applies(component):
    return bool(component.commands) and component.mimic is not None

def R2C016_applies(component):
    mimic = component.mimic
    return mimic is not None and mimic.leader is not None and (mimic.leader_name not in component.block.joints)

def R2C017_applies(component):
    value, joint = (component.mimic_value, component.joint)
    return value is not None and value.text.strip().lower() == 'true' and (joint is not None) and (joint.axis.mimic is None)

def R2C018_applies(component):
    return component.what == 'joint' and bool(component.mimic_parameters)

def R2C019_applies(block):
    return any((True for _ in block.unsound))

def R2C020_applies(interface):
    return bool(interface.malformed)

def R2C021_applies(interface):
    return interface.minimum.number > interface.maximum.number

def R2C022_applies(interface):
    joint = interface.component.joint
    if joint is None or interface.is_command or interface.name != 'position' or (joint.axis_count != 1):
        return False
    low, high = joint.axis.limit.range
    return interface.initial.number < low or interface.initial.number > high

def R2C023_applies(interface):
    component = interface.component
    return interface.is_command and 'sensor' in {component.what, component.block.type}

r2c_misspelled_interface__OF_JOINTS = frozenset('\n    acceleration current derivative effort feedforward force integral jerk position position_pid\n    proportional temperature torque velocity velocity_pid\n    '.split())

r2c_misspelled_interface__OF_SENSORS = frozenset((f'{what}.{axis}' for what, axes in (('orientation', 'xyzw'), ('angular_velocity', 'xyz'), ('linear_acceleration', 'xyz'), ('force', 'xyz'), ('torque', 'xyz'), ('magnetic_field', 'xyz')) for axis in axes))

r2c_misspelled_interface__SHORT = {'acc': 'acceleration', 'eff': 'effort', 'pos': 'position', 'vel': 'velocity'}

def r2c_misspelled_interface__meant(interface):
    name, what = (interface.name, interface.component.what)
    known = r2c_misspelled_interface__OF_JOINTS if what == 'joint' else r2c_misspelled_interface__OF_SENSORS if what == 'sensor' else frozenset[str]()
    if name in known:
        return None
    if what == 'joint' and name in r2c_misspelled_interface__SHORT:
        return r2c_misspelled_interface__SHORT[name]
    near = sdfcheck_.suggest(name.replace('.', '_'), {each.replace('.', '_'): each for each in known})
    if near is None or name.startswith((f'{near}_', f'{near}.', f'{near}1', f'{near}2')):
        return None
    return next((each for each in known if each.replace('.', '_') == near))

def R2C024_applies(interface):
    return interface.is_readable and r2c_misspelled_interface__meant(interface) is not None

def R2C025_applies(transmission):
    return bool(transmission.unresolved)

r2c_unknown_imu_interface__IMU = frozenset((f'{what}.{axis}' for what, axes in (('orientation', 'xyzw'), ('angular_velocity', 'xyz'), ('linear_acceleration', 'xyz')) for axis in axes))

def r2c_unknown_imu_interface__is_near(name):
    return sdfcheck_.suggest(name.replace('.', '_'), {each.replace('.', '_') for each in r2c_unknown_imu_interface__IMU}) is not None

def R2C026_applies(interface):
    component = interface.component
    if component.sensor is None or interface.is_command or interface.name in r2c_unknown_imu_interface__IMU or (not interface.is_readable):
        return False
    return component.sensor.type == 'imu' and component.block.is_simulated and (not r2c_unknown_imu_interface__is_near(interface.name))

r2c_control_plugin_without_parameters__NEEDY = frozenset((f'{prefix}{name}{suffix}' for name in ('gz_ros2_control-system', 'ign_ros2_control-system') for prefix, suffix in (('', ''), ('lib', '.so'), ('lib', ''), ('', '.so'))))

def R2C027_applies(plugin):
    return plugin.filename in r2c_control_plugin_without_parameters__NEEDY and (not any((each.content for each in plugin.children('parameters'))))

r2c_unknown_control_simulator__CLASSES = {'gz_ros2_control-system': ('gz_ros2_control::GazeboSimROS2ControlPlugin', 'ign_ros2_control::IgnitionROS2ControlPlugin'), 'ign_ros2_control-system': ('ign_ros2_control::IgnitionROS2ControlPlugin',)}

def R2C028_applies(plugin):
    file = plugin.filename.removeprefix('lib').removesuffix('.so')
    if file in r2c_unknown_control_simulator__CLASSES:
        return bool(plugin.name) and plugin.name not in r2c_unknown_control_simulator__CLASSES[file]
    return sdfcheck_.suggest(file, r2c_unknown_control_simulator__CLASSES) is not None

def R2C029_applies(block):
    return block.is_simulated and (not any(('ros2_control' in plugin.filename for plugin in block.model.plugins)))

def R2C030_applies(component):
    return not component.interfaces and (not any((child.name != 'param' for child in component.children())))

def R2C031_applies(interface):
    if interface.component.what != 'joint' or interface.is_limited:
        return False
    return interface.minimum.is_given or interface.maximum.is_given

def R2C032_applies(interface):
    return any((True for _ in interface.widened))

def R2C033_applies(interface):
    if not interface.is_limited or interface.name not in {'velocity', 'effort'}:
        return False
    low, high = (interface.minimum, interface.maximum)
    return low.is_given and high.is_given and (low.number <= high.number) and (abs(low.number + high.number) > 1e-09)

def r2c_mixed_control_generations__library_of(plugin):
    return plugin.filename.removeprefix('lib').removesuffix('.so')

r2c_mixed_control_generations__SYSTEMS = {'gazebo_ros2_control': ('gazebo_ros2_control/GazeboSystem',), 'gz_ros2_control-system': ('gz_ros2_control/GazeboSimSystem', 'ign_ros2_control/IgnitionSystem'), 'ign_ros2_control-system': ('ign_ros2_control/IgnitionSystem',)}

def r2c_mixed_control_generations__loader(block):
    value = block.plugin_value
    known = [plugin for plugin in block.model.plugins if r2c_mixed_control_generations__library_of(plugin) in r2c_mixed_control_generations__SYSTEMS]
    for plugin in known:
        library = r2c_mixed_control_generations__library_of(plugin)
        is_misnamed = library in r2c_unknown_control_simulator__CLASSES and plugin.name not in r2c_unknown_control_simulator__CLASSES[library]
        if is_misnamed or (value is not None and value.text in r2c_mixed_control_generations__SYSTEMS[library]):
            return None
    return known[0] if known else None

def R2C034_applies(block):
    return block.is_simulated and r2c_mixed_control_generations__loader(block) is not None

def RES001_applies(root):
    return any((resource.is_missing for resource in root.resources))

def RES002_applies(root):
    return any((include.is_missing or include.needs_config for include in root.includes))

def res_include_cycle__real_path(step):
    return os_.path.realpath(step.element.document.path)

def RES003_applies(include):
    ring = include.ring
    return bool(ring) and res_include_cycle__real_path(ring[0]) == min(map(res_include_cycle__real_path, ring))

def RES004_applies(named):
    return named.misspelling is not None

def RES005_applies(named):
    return named.other_case is not None

res_absolute_path__HOME = re_.compile('(?:file://)?/(?:home|Users)/[^/\\s]+/\\S+')

def res_absolute_path__of_somebody(plugin):
    for parameter in plugin.parameters:
        if not parameter.nodes and res_absolute_path__HOME.match(parameter.content):
            yield parameter.own_value

def RES006_applies(named):
    if isinstance(named, sdfcheck_.Plugin):
        return next(res_absolute_path__of_somebody(named), None) is not None
    return named.is_absolute and named.misspelling is None and (named.obstacle is None)

def RES007_applies(subject):
    return subject.is_misconfigured

def res_missing_plugin_attribute__lacks_file(plugin):
    return not plugin.filename and (not plugin.misspells('filename'))

res_missing_plugin_attribute__NAMELESS_SINCE = '1.10'

def res_missing_plugin_attribute__lacks_name(plugin):
    if plugin.name_value is not None or plugin.root.is_urdf:
        return False
    return plugin.root.is_older_than(res_missing_plugin_attribute__NAMELESS_SINCE) and (not plugin.misspells('name'))

def RES008_applies(plugin):
    return res_missing_plugin_attribute__lacks_file(plugin) or res_missing_plugin_attribute__lacks_name(plugin)

res_invalid_merge_include__NOT_INTO_WORLDS = ('link', 'gripper')

def RES009_applies(include):
    if not include.is_merged or include.brought is None:
        return False
    into = include.element.parent.name if include.element.parent is not None else ''
    if include.found.kind != 'model' or into not in {'model', 'world'}:
        return True
    return into == 'world' and any((kind in res_invalid_merge_include__NOT_INTO_WORLDS for kind, _ in include.merged_parts))

res_unknown_collision_reference__DEFAULT = '__default__'

def res_unknown_collision_reference__misnamed(contact):
    block = contact.holder.holder if contact.holder is not None else None
    if not isinstance(block, sdfcheck_.GazeboBlock) or block.link is None or (not block.link.model.is_complete):
        return []
    built = block.model.as_built_by(sdfcheck_.Consumer.GAZEBO)
    link = built.links.get(built.base(block.link).name)
    if link is None:
        return []
    names = {'', res_unknown_collision_reference__DEFAULT, *(collision.name for collision in link.collisions)}
    return [(value, link) for value in contact.collision_names if value.text.strip() not in names and '::' not in value.text and ('$' not in value.text)]

def RES011_applies(part):
    return bool(part.unresolved or (isinstance(part, sdfcheck_.Contact) and res_unknown_collision_reference__misnamed(part)))

res_unusable_include__SETTINGS = ('name', 'static', 'placement_frame')

def res_unusable_include__empty_settings(include):
    return (setting for name in res_unusable_include__SETTINGS for setting in include.children(name) if not setting.content)

def RES012_applies(include):
    return include.is_read_in_vain or any((True for _ in res_unusable_include__empty_settings(include)))

res_unportable_mesh_uri__RELATIVE = ''

res_unportable_mesh_uri__MODEL = 'model'

def res_unportable_mesh_uri__scheme(resource):
    uri = resource.uri
    if not resource.is_urdf or uri.startswith('/') or '$' in uri or ('\\' in uri):
        return None
    head, delimiter, _ = uri.partition('://')
    found = head.lower() if delimiter else res_unportable_mesh_uri__RELATIVE
    return found if found in (res_unportable_mesh_uri__RELATIVE, res_unportable_mesh_uri__MODEL) and ':/' not in head else None

def RES013_applies(root):
    return root.is_urdf and any((res_unportable_mesh_uri__scheme(resource) is not None for resource in root.resources))

def res_unknown_plugin_reference__merged(plugin):
    links = [found for found in plugin.references if found.kind == 'link'] if plugin.is_extension else ()
    for value, _, _, node in links:
        if not isinstance(node, sdfcheck_.Link) or not node.is_urdf:
            continue
        built = node.model.as_built_by(sdfcheck_.Consumer.GAZEBO)
        left = built.base(node)
        if left is not node and value.element not in built.rewritten(plugin):
            yield (value, node, left)

def RES014_applies(plugin):
    return bool(plugin.unresolved or any(res_unknown_plugin_reference__merged(plugin)))

def RES015_applies(plugin):
    is_gone = plugin.known is not None and bool(plugin.known.last) and ('ignition' not in plugin.filename)
    return is_gone or plugin.meant_file is not None

res_plugin_name_mismatch__GZ_SIM = 'gz-sim'

def RES016_applies(plugin):
    if not plugin.name or plugin.known is None or plugin.known.generation != res_plugin_name_mismatch__GZ_SIM:
        return False
    return '$' not in plugin.name and (not plugin.known.is_class(plugin.name))

def res_repeated_system__distinction(plugin):
    texts = (plugin.get('robotNamespace'), plugin.get('namespace'), plugin.get('controller_manager_name'))
    return (*texts, plugin.get('ros/namespace'))

def res_repeated_system__first(plugin):
    for sibling in plugin.siblings:
        if sibling is plugin:
            return None
        if sibling.known == plugin.known and res_repeated_system__distinction(sibling) == res_repeated_system__distinction(plugin):
            return sibling
    return None

def RES017_applies(plugin):
    return plugin.known is not None and plugin.known.once != '' and (res_repeated_system__first(plugin) is not None)

def RES018_applies(world):
    return any(world.unserved_sensors)

def RES019_applies(plugin):
    return any(plugin.misspelled_parameters)

def res_unknown_performer__unknown(plugin):
    world = plugin.holder
    if not isinstance(world, sdfcheck_.World) or plugin.name not in {'gz::sim', 'ignition::gazebo'}:
        return
    actors = {actor.name for actor in world.actors}
    for performer in plugin.children('performer'):
        reference = performer.find('ref')
        name = '' if reference is None else reference.content
        if reference is None or not name or '$' in name or (name in actors):
            continue
        node = world.resolve(name)
        if (node is None or node.kind != 'model') and (not world.may_hold(name)):
            yield (reference.own_value, world)

def RES020_applies(plugin):
    return any((True for _ in res_unknown_performer__unknown(plugin)))

def RES021_applies(plugin):
    return bool(plugin.missing_parameters)

def RES022_applies(plugin):
    return bool(plugin.repeated_parameters)

res_unknown_world_topic__TOPIC = re_.compile('/?world/([^/\\s{}$]+)/\\S*')

def res_unknown_world_topic__foreign(plugin):
    if plugin.within(sdfcheck_.World) is None:
        return
    worlds = {world.name for world in plugin.root.worlds}
    for parameter in plugin.parameters:
        match = res_unknown_world_topic__TOPIC.fullmatch(parameter.content) if not parameter.nodes else None
        if match is not None and match[1] not in worlds:
            yield (parameter.own_value, match[1])

def RES023_applies(plugin):
    return next(res_unknown_world_topic__foreign(plugin), None) is not None

def SCH001_applies(root):
    if root.is_urdf or root.element.name != 'sdf' or root.misspells('version'):
        return False
    return not (root.version or '').strip()

sch_unknown_version__URDF_VERSIONS = ('1.0', '1.1', '1.2')

sch_unknown_version__SDF_VERSIONS = ('1.2', '1.3', '1.4', '1.5', '1.6', '1.7', '1.8', '1.9', '1.10', '1.11', '1.12')

def sch_unknown_version__known_versions(root):
    return sch_unknown_version__URDF_VERSIONS if root.is_urdf else sch_unknown_version__SDF_VERSIONS

def SCH002_applies(root):
    version = root.version
    if version is None or version in sch_unknown_version__known_versions(root):
        return False
    return root.is_urdf or bool(version.strip())

def sch_missing_shape__is_of_link(element):
    if element.parent is None or element.parent.name != 'link':
        return False
    return not any((ancestor.name == 'state' for ancestor in element.around))

def sch_missing_shape__without_shape(root):
    if root.is_urdf:
        return
    geometries = root.elements.get('geometry', ())
    shaped = {geometry.parent for geometry in geometries}
    for kind in ('visual', 'collision'):
        for element in root.elements.get(kind, ()):
            if element not in shaped and sch_missing_shape__is_of_link(element) and (not root.part_of(element).misspells('geometry')):
                yield element
    for geometry in geometries:
        is_empty = next(geometry.children(), None) is None
        if is_empty and geometry.parent is not None and (geometry.parent.name != 'sonar'):
            yield geometry

def SCH016_applies(root):
    return any((True for _ in sch_missing_shape__without_shape(root)))

def sch_mismatched_sensor__wrong_settings(sensor):
    names = sensor.settings_names
    return next((given for given in sensor.given_settings if given.name not in names), None)

sch_mismatched_sensor__NEED_SETTINGS = ('camera', 'contact', 'lidar', 'logical_camera')

def sch_mismatched_sensor__lacks_settings(sensor):
    return sensor.settings_names[0] in sch_mismatched_sensor__NEED_SETTINGS and (not sensor.given_settings)

def SCH018_applies(sensor):
    expected = sensor.settings_names
    if not expected or any((sensor.misspells(name) for name in expected)):
        return False
    return sch_mismatched_sensor__wrong_settings(sensor) is not None or sch_mismatched_sensor__lacks_settings(sensor)

def sch_impossible_cone__angle_of(light, name):
    spot = light.find('spot')
    written = None if spot is None else spot.find(name)
    return math_.nan if written is None else written.own_value.number

def sch_impossible_cone__wrong_angle(light):
    inner, outer = (sch_impossible_cone__angle_of(light, 'inner_angle'), sch_impossible_cone__angle_of(light, 'outer_angle'))
    if outer > 2 * math_.pi:
        return 'outer_angle'
    return 'inner_angle' if inner > outer else ''

def SCH021_applies(light):
    return light.has('spot') and light.type == 'spot' and bool(sch_impossible_cone__wrong_angle(light))

def sch_zero_direction__zero_directions(root):
    for element in (*root.elements.get('normal', ()), *root.elements.get('direction', ())):
        holder = element.parent
        if holder is None or holder.name not in {'plane', 'light'}:
            continue
        if holder.name == 'light' and holder.text_of('type', 'point').strip() == 'point':
            continue
        words = element.content.split()
        if len(words) == 3 and all((word.strip('0.+-') == '' and '0' in word for word in words)):
            yield element.own_value

def SCH022_applies(root):
    return any((True for _ in sch_zero_direction__zero_directions(root)))

def sch_zero_mesh_scale__scale(geometry):
    mesh = geometry.find('mesh')
    value = None if mesh is None else mesh.value('scale')
    return sdfcheck_.Vector.of(value, geometry.element, (1.0, 1.0, 1.0))

def SCH023_applies(geometry):
    return geometry.has('mesh') and 0 in sch_zero_mesh_scale__scale(geometry)

def sch_negative_light_range__reach(light):
    attenuation = light.find('attenuation')
    value = None if attenuation is None else attenuation.value('range')
    return sdfcheck_.Number.of(value, light.element, 10.0)

def SCH024_applies(light):
    return light.has('attenuation') and sch_negative_light_range__reach(light).number < 0

sch_scan_in_degrees__NAMES = ('min_angle', 'max_angle')

sch_scan_in_degrees__TURN = 2 * math_pi * 1.01

def sch_scan_in_degrees__wide_angles(sensor):
    for name in ('lidar', 'ray'):
        settings = sensor.find(name)
        scan = None if settings is None else settings.find('scan')
        for direction in () if scan is None else scan.children():
            for angle in sch_scan_in_degrees__NAMES if direction.name in {'horizontal', 'vertical'} else ():
                value = direction.value(angle)
                if value is not None and sch_scan_in_degrees__TURN < abs(value.number) < 1000000.0:
                    yield value

def SCH025_applies(sensor):
    return (sensor.has('lidar') or sensor.has('ray')) and any(sch_scan_in_degrees__wide_angles(sensor))

sch_long_step__MOST = 0.5

def SCH026_applies(physics):
    return physics.max_step_size.number >= sch_long_step__MOST

def sch_unknown_animation__animations(actor):
    names = {animation.attributes.get('name', '').strip() for animation in actor.animations}
    return names - {''}

def sch_unknown_animation__unknown(actor):
    names = sch_unknown_animation__animations(actor)
    for trajectory in actor.trajectories:
        value = trajectory.attribute('type')
        if value is not None and value.text.strip() and (value.text.strip() not in names):
            yield value

def SCH027_applies(actor):
    return bool(actor.animations) and any(sch_unknown_animation__unknown(actor))

def sch_unordered_waypoints__disorder(actor):
    for trajectory in actor.trajectories:
        written = (waypoint.value('time') for waypoint in trajectory.children('waypoint'))
        times = [value for value in written if value is not None]
        pairs = itertools_pairwise(times)
        found = next((pair for pair in pairs if pair[0].number >= pair[1].number), None)
        if found is not None:
            yield found

def SCH028_applies(actor):
    return any(sch_unordered_waypoints__disorder(actor))

def sch_empty_trajectory__is_empty(trajectory):
    return next(trajectory.children(), None) is None

def SCH029_applies(actor):
    return any(map(sch_empty_trajectory__is_empty, actor.trajectories))

sch_blank_in_topic__QUOTES = ("'", '"')

def sch_blank_in_topic__topic(sensor):
    value = sensor.value('topic')
    if value is None or '$' in value.text:
        return None
    return value if len(value.text.split()) > 1 or any((mark in value.text for mark in sch_blank_in_topic__QUOTES)) else None

def SCH030_applies(sensor):
    return sensor.has('topic') and sch_blank_in_topic__topic(sensor) is not None

sch_dropped_by_update__OLD = '1.9'

def sch_dropped_by_update__dropped(root):
    for element in root.elements.get('initial_position', ()):
        if element.parent is not None and element.parent.name in {'axis', 'axis2'}:
            yield element
    if 'relative_to' in root.document.source.text and (not root.is_older_than('1.7')) and root.is_older_than('1.8'):
        for inertial in root.elements.get('inertial', ()):
            pose = inertial.find('pose')
            if pose is not None and pose.attribute('relative_to') is not None:
                yield pose

def SCH031_applies(root):
    return root.is_older_than(sch_dropped_by_update__OLD) and next(sch_dropped_by_update__dropped(root), None) is not None

sch_resolution_of_scan__MOST = 0.2

sch_resolution_of_scan__COARSE = 0.0175

def sch_resolution_of_scan__thinned(sensor):
    for name in ('lidar', 'ray'):
        settings = sensor.find(name)
        scan = None if settings is None else settings.find('scan')
        for direction in () if scan is None else scan.children():
            resolution, samples = (direction.value('resolution'), direction.value('samples'))
            low, high = (direction.value('min_angle'), direction.value('max_angle'))
            if resolution is None or samples is None or low is None or (high is None) or (not samples.number > 1):
                continue
            beams = resolution.number * samples.number
            if 0 < resolution.number < sch_resolution_of_scan__MOST and high.number - low.number > sch_resolution_of_scan__COARSE * beams:
                yield (resolution, samples)

def SCH032_applies(sensor):
    return any((True for _ in sch_resolution_of_scan__thinned(sensor)))

def sch_mismatched_intrinsics__within(element, *path):
    found = element
    for name in path:
        found = None if found is None else found.find(name)
    return found

def sch_mismatched_intrinsics__value_within(element, *path):
    found = sch_mismatched_intrinsics__within(element, *path)
    return None if found is None else found.own_value

def sch_mismatched_intrinsics__is_measured(intrinsics):
    fx, fy, cx, cy = (sch_mismatched_intrinsics__value_within(intrinsics, name) for name in ('fx', 'fy', 'cx', 'cy'))
    if fx is not None and fy is not None and (fx.number != fy.number):
        return True
    return any((middle is not None and 2 * middle.number % 1 for middle in (cx, cy)))

sch_mismatched_intrinsics__MOST = 0.01

def sch_mismatched_intrinsics__focal(sensor):
    camera = sensor.find('camera')
    intrinsics = None if camera is None else sch_mismatched_intrinsics__within(camera, 'lens', 'intrinsics')
    if camera is None or intrinsics is None or sch_mismatched_intrinsics__is_measured(intrinsics):
        return None
    view, width = (sch_mismatched_intrinsics__value_within(camera, 'horizontal_fov'), sch_mismatched_intrinsics__value_within(camera, 'image', 'width'))
    given = sch_mismatched_intrinsics__value_within(intrinsics, 'fx')
    if view is None or width is None or given is None:
        return None
    if not 0 < view.number < math_pi or not width.number > 0 or (not given.number > 0):
        return None
    right = width.number / 2 / math_tan(view.number / 2)
    return (given, width, view) if abs(given.number - right) > sch_mismatched_intrinsics__MOST * right else None

def SCH033_applies(sensor):
    return sch_mismatched_intrinsics__focal(sensor) is not None

def SRD001_applies(semantics):
    return bool(semantics.robots) and any((True for _ in semantics.unknown))

def SRD002_applies(semantics):
    return any((True for _ in semantics.unknown_groups))

def SRD003_applies(semantics):
    return any((True for _ in semantics.lacking))

def SRD004_applies(semantics):
    return any((True for _ in semantics.doubled))

def SRD005_applies(semantics):
    return any((semantics.miscounted(each) is not None for each in semantics.state_values))

def SRD006_applies(semantics):
    return any((semantics.outside(each) is not None for each in semantics.state_values))

def SRD007_applies(semantics):
    return bool(semantics.strangers) or semantics.namesake is not None

def SRD008_applies(semantics):
    return any((True for _ in semantics.misplaced_virtual_joints))

def URD003_applies(robot):
    return any((len(group) > 1 for group in robot.tree.loose_groups))

def URD004_applies(robot):
    return bool(robot.link_names.misspelled) or any((len(group) == 1 for group in robot.tree.loose_groups))

urd_missing_limit__BOUNDED = ('revolute', 'prismatic')

urd_missing_limit__REQUIRED = ('effort', 'velocity')

def urd_missing_limit__is_locked(limit):
    lower, upper = (limit.attribute('lower'), limit.attribute('upper'))
    return lower is None and upper is None and (limit.joint.type in urd_missing_limit__BOUNDED)

def URD005_applies(part):
    if part.kind == 'joint':
        return not part.has('limit') and part.type in urd_missing_limit__BOUNDED and part.lacks('limit')
    return any(map(part.lacks, urd_missing_limit__REQUIRED)) or urd_missing_limit__is_locked(part)

def urd_undefined_material__is_empty(material):
    return not material.has_look and material.lacks('color') and material.lacks('texture')

def URD006_applies(robot):
    names = robot.material_names
    return bool(names.undefined or names.redefined) or any(map(urd_undefined_material__is_empty, robot.materials))

urd_missing_geometry__SHAPES = ('box', 'capsule', 'cylinder', 'mesh', 'sphere')

def urd_missing_geometry__lacks_shape(geometry):
    mesh = geometry.find('mesh')
    if mesh is not None and geometry.part(mesh).lacks('filename'):
        return True
    return geometry.shape not in urd_missing_geometry__SHAPES and (not geometry.is_unfinished)

def URD007_applies(shape):
    return urd_missing_geometry__lacks_shape(shape.geometry) if shape.geometry.is_given else shape.lacks('geometry')

def URD008_applies(link):
    if link.name == 'world' or not link.has_mass:
        return False
    return bool(link.child_joints) and link in link.model.tree.main_roots

urd_incomplete_inertia__PARTS = ('mass', 'inertia')

def URD010_applies(inertial):
    return bool(inertial.missing_moments) or any(map(inertial.lacks, urd_incomplete_inertia__PARTS))

def URD011_applies(transmission):
    return bool(transmission.unresolved)

def URD012_applies(control):
    return bool(control.unresolved)

def urd_vanishing_root__is_world_alone(robot):
    return len(robot.links) == 1 and robot.links[0].name == 'world'

def URD013_applies(robot):
    built = robot.as_built_by(sdfcheck_.Consumer.GAZEBO)
    return not built.with_mass.issuperset(built.tops) or urd_vanishing_root__is_world_alone(robot)

def urd_massless_moving_link__is_apart(link):
    joint = link.parent_joints[0]
    return joint.moves or joint.is_preserved

def urd_massless_moving_link__dropped(robot):
    built = robot.as_built_by(sdfcheck_.Consumer.GAZEBO)
    found = []
    for top in built.tops:
        members = list(top.below())
        if any((link.has_mass for link in members)):
            found += [link for link in members[1:] if link not in built.with_mass and urd_massless_moving_link__is_apart(link)]
    return found

def URD014_applies(robot):
    return bool(urd_massless_moving_link__dropped(robot))

urd_colon_in_comment__QUICK = re_.compile('<!--(?:(?!-->)[^:])*(?::|\\Z)')

urd_colon_in_comment__COLON = re_.compile(':(?=\\s)')

def urd_colon_in_comment__colons(root):
    source = root.document.source
    return [source.span(*match.span()) for start, end in root.document.scan.comments for match in urd_colon_in_comment__COLON.finditer(source.text, start + 4, end - 3)]

def URD015_applies(root):
    return root.is_urdf and urd_colon_in_comment__QUICK.search(root.document.source.text) is not None and bool(urd_colon_in_comment__colons(root))

urd_singular_pitch__POLE = 0.99999

def urd_singular_pitch__error(origin):
    if len(origin.rotation) != 3 or not math_.isfinite(origin.rotation[1]):
        return 0.0
    sine = abs(math_.sin(origin.rotation[1]))
    return math_.pi / 2 - math_.asin(min(sine, 1.0)) if sine >= urd_singular_pitch__POLE else 0.0

urd_singular_pitch__NOTABLE = 0.0001

def URD016_applies(origin):
    return not origin.is_quaternion and urd_singular_pitch__error(origin) > urd_singular_pitch__NOTABLE

def urd_delimiter_in_extension___is_in_plugin(element):
    return element.name == 'plugin' or any((around.name == 'plugin' for around in element.around))

def urd_delimiter_in_extension__delimited(block):
    named = (element.attribute('name') for element in block.all_elements() if not urd_delimiter_in_extension___is_in_plugin(element))
    return [value for value in named if value is not None and '::' in value.text]

def URD017_applies(block):
    return block.document.source.contains('::') and bool(urd_delimiter_in_extension__delimited(block))

def URD018_applies(mimic):
    return not mimic.joint.is_fixed and mimic.leader is not None and mimic.leader.is_fixed

def URD020_applies(joint):
    return joint.is_unconverted

def URD021_applies(link):
    return link.name.startswith('/')

def URD022_applies(node):
    return ' ' in node.name

def URD023_applies(mimic):
    is_late = mimic.next is not None and mimic.leader_name > mimic.joint.name
    return is_late and (not mimic.leads_into_ring)

urd_missing_hardware_interface__PREFIX = 'transmission_interface/'

def urd_missing_hardware_interface__bare_joints(transmission):
    return [joint for joint in transmission.joint_elements if not joint.has('hardwareInterface')]

def urd_missing_hardware_interface__is_for_ros_control(transmission):
    text = transmission.document.source.text
    return '<hardwareInterface' in text or 'ros_control' in text

def URD024_applies(transmission):
    value = transmission.type_value
    is_ours = value is not None and value.text.strip().startswith(urd_missing_hardware_interface__PREFIX)
    return is_ours and bool(urd_missing_hardware_interface__bare_joints(transmission)) and urd_missing_hardware_interface__is_for_ros_control(transmission)

urd_unprefixed_hardware_interface__BARE = frozenset(('EffortJointInterface', 'PositionJointInterface', 'VelocityJointInterface'))

def urd_unprefixed_hardware_interface__bare_names(part):
    for interface in part.children('hardwareInterface'):
        if interface.content.strip() in urd_unprefixed_hardware_interface__BARE:
            yield interface.own_value

def urd_unprefixed_hardware_interface__is_bare(part):
    return any(urd_unprefixed_hardware_interface__bare_names(part))

def urd_unprefixed_hardware_interface__bare_transmissions(document):
    transmissions = (element for element in document.elements if element.name == 'transmission')
    return [each for each in transmissions if any(map(urd_unprefixed_hardware_interface__is_bare, each.children('joint')))]

def URD026_applies(transmission):
    is_old = any(map(urd_unprefixed_hardware_interface__is_bare, transmission.children('joint')))
    return is_old and transmission.document.view(urd_unprefixed_hardware_interface__bare_transmissions)[0] is transmission

xml_missing_root__OLD = 'gazebo'

xml_missing_root__FORGOTTEN = frozenset({'model', 'world', xml_missing_root__OLD})

def XML011_applies(root):
    return not root.is_urdf and root.element.name in xml_missing_root__FORGOTTEN and (root.document.kind.value == 'sdf')

CONDITIONS = {
    'DRK001': DRK001_applies,
    'DRK002': DRK002_applies,
    'DRK003': DRK003_applies,
    'DRK004': DRK004_applies,
    'DRK005': DRK005_applies,
    'DRK006': DRK006_applies,
    'DRK007': DRK007_applies,
    'DRK016': DRK016_applies,
    'DRK017': DRK017_applies,
    'DRK018': DRK018_applies,
    'DRK019': DRK019_applies,
    'DRK020': DRK020_applies,
    'DRK021': DRK021_applies,
    'DRK022': DRK022_applies,
    'FRM001': FRM001_applies,
    'FRM002': FRM002_applies,
    'FRM003': FRM003_applies,
    'FRM004': FRM004_applies,
    'FRM005': FRM005_applies,
    'FRM006': FRM006_applies,
    'FRM007': FRM007_applies,
    'FRM008': FRM008_applies,
    'FRM009': FRM009_applies,
    'GAZ001': GAZ001_applies,
    'GAZ003': GAZ003_applies,
    'GAZ004': GAZ004_applies,
    'GAZ005': GAZ005_applies,
    'GAZ006': GAZ006_applies,
    'GAZ007': GAZ007_applies,
    'GAZ008': GAZ008_applies,
    'GAZ009': GAZ009_applies,
    'GAZ010': GAZ010_applies,
    'GAZ011': GAZ011_applies,
    'GAZ012': GAZ012_applies,
    'GAZ013': GAZ013_applies,
    'GAZ014': GAZ014_applies,
    'GAZ015': GAZ015_applies,
    'GAZ016': GAZ016_applies,
    'GAZ017': GAZ017_applies,
    'GEO001': GEO001_applies,
    'GEO002': GEO002_applies,
    'GEO003': GEO003_applies,
    'GEO004': GEO004_applies,
    'GEO005': GEO005_applies,
    'GEO006': GEO006_applies,
    'GEO007': GEO007_applies,
    'GEO008': GEO008_applies,
    'GEO009': GEO009_applies,
    'GEO010': GEO010_applies,
    'GEO011': GEO011_applies,
    'GEO012': GEO012_applies,
    'GEO013': GEO013_applies,
    'GEO014': GEO014_applies,
    'INR001': INR001_applies,
    'INR002': INR002_applies,
    'INR003': INR003_applies,
    'INR004': INR004_applies,
    'INR005': INR005_applies,
    'INR006': INR006_applies,
    'INR007': INR007_applies,
    'INR008': INR008_applies,
    'INR009': INR009_applies,
    'INR010': INR010_applies,
    'INR011': INR011_applies,
    'INR012': INR012_applies,
    'INR013': INR013_applies,
    'INR014': INR014_applies,
    'INR015': INR015_applies,
    'INR016': INR016_applies,
    'INR017': INR017_applies,
    'JNT001': JNT001_applies,
    'JNT002': JNT002_applies,
    'JNT003': JNT003_applies,
    'JNT004': JNT004_applies,
    'JNT005': JNT005_applies,
    'JNT006': JNT006_applies,
    'JNT007': JNT007_applies,
    'JNT008': JNT008_applies,
    'JNT009': JNT009_applies,
    'JNT010': JNT010_applies,
    'JNT011': JNT011_applies,
    'JNT012': JNT012_applies,
    'JNT013': JNT013_applies,
    'JNT014': JNT014_applies,
    'JNT015': JNT015_applies,
    'JNT016': JNT016_applies,
    'JNT017': JNT017_applies,
    'JNT018': JNT018_applies,
    'JNT019': JNT019_applies,
    'JNT020': JNT020_applies,
    'JNT021': JNT021_applies,
    'JNT022': JNT022_applies,
    'JNT023': JNT023_applies,
    'MUJ001': MUJ001_applies,
    'MUJ002': MUJ002_applies,
    'MUJ003': MUJ003_applies,
    'MUJ004': MUJ004_applies,
    'MUJ005': MUJ005_applies,
    'NAM001': NAM001_applies,
    'NAM002': NAM002_applies,
    'NAM003': NAM003_applies,
    'NAM004': NAM004_applies,
    'NAM005': NAM005_applies,
    'NAM007': NAM007_applies,
    'NS003': NS003_applies,
    'NS004': NS004_applies,
    'NS005': NS005_applies,
    'NS006': NS006_applies,
    'NS007': NS007_applies,
    'NS008': NS008_applies,
    'NS009': NS009_applies,
    'NS010': NS010_applies,
    'NS011': NS011_applies,
    'NS012': NS012_applies,
    'NS013': NS013_applies,
    'NS014': NS014_applies,
    'R2C001': R2C001_applies,
    'R2C002': R2C002_applies,
    'R2C003': R2C003_applies,
    'R2C004': R2C004_applies,
    'R2C005': R2C005_applies,
    'R2C006': R2C006_applies,
    'R2C007': R2C007_applies,
    'R2C008': R2C008_applies,
    'R2C009': R2C009_applies,
    'R2C010': R2C010_applies,
    'R2C011': R2C011_applies,
    'R2C012': R2C012_applies,
    'R2C013': R2C013_applies,
    'R2C014': R2C014_applies,
    'R2C015': R2C015_applies,
    'R2C016': R2C016_applies,
    'R2C017': R2C017_applies,
    'R2C018': R2C018_applies,
    'R2C019': R2C019_applies,
    'R2C020': R2C020_applies,
    'R2C021': R2C021_applies,
    'R2C022': R2C022_applies,
    'R2C023': R2C023_applies,
    'R2C024': R2C024_applies,
    'R2C025': R2C025_applies,
    'R2C026': R2C026_applies,
    'R2C027': R2C027_applies,
    'R2C028': R2C028_applies,
    'R2C029': R2C029_applies,
    'R2C030': R2C030_applies,
    'R2C031': R2C031_applies,
    'R2C032': R2C032_applies,
    'R2C033': R2C033_applies,
    'R2C034': R2C034_applies,
    'RES001': RES001_applies,
    'RES002': RES002_applies,
    'RES003': RES003_applies,
    'RES004': RES004_applies,
    'RES005': RES005_applies,
    'RES006': RES006_applies,
    'RES007': RES007_applies,
    'RES008': RES008_applies,
    'RES009': RES009_applies,
    'RES011': RES011_applies,
    'RES012': RES012_applies,
    'RES013': RES013_applies,
    'RES014': RES014_applies,
    'RES015': RES015_applies,
    'RES016': RES016_applies,
    'RES017': RES017_applies,
    'RES018': RES018_applies,
    'RES019': RES019_applies,
    'RES020': RES020_applies,
    'RES021': RES021_applies,
    'RES022': RES022_applies,
    'RES023': RES023_applies,
    'SCH001': SCH001_applies,
    'SCH002': SCH002_applies,
    'SCH016': SCH016_applies,
    'SCH018': SCH018_applies,
    'SCH021': SCH021_applies,
    'SCH022': SCH022_applies,
    'SCH023': SCH023_applies,
    'SCH024': SCH024_applies,
    'SCH025': SCH025_applies,
    'SCH026': SCH026_applies,
    'SCH027': SCH027_applies,
    'SCH028': SCH028_applies,
    'SCH029': SCH029_applies,
    'SCH030': SCH030_applies,
    'SCH031': SCH031_applies,
    'SCH032': SCH032_applies,
    'SCH033': SCH033_applies,
    'SRD001': SRD001_applies,
    'SRD002': SRD002_applies,
    'SRD003': SRD003_applies,
    'SRD004': SRD004_applies,
    'SRD005': SRD005_applies,
    'SRD006': SRD006_applies,
    'SRD007': SRD007_applies,
    'SRD008': SRD008_applies,
    'URD003': URD003_applies,
    'URD004': URD004_applies,
    'URD005': URD005_applies,
    'URD006': URD006_applies,
    'URD007': URD007_applies,
    'URD008': URD008_applies,
    'URD010': URD010_applies,
    'URD011': URD011_applies,
    'URD012': URD012_applies,
    'URD013': URD013_applies,
    'URD014': URD014_applies,
    'URD015': URD015_applies,
    'URD016': URD016_applies,
    'URD017': URD017_applies,
    'URD018': URD018_applies,
    'URD020': URD020_applies,
    'URD021': URD021_applies,
    'URD022': URD022_applies,
    'URD023': URD023_applies,
    'URD024': URD024_applies,
    'URD026': URD026_applies,
    'XML011': XML011_applies,
}
