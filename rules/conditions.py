"""The conditions of the rules, so that a clean file loads one module; written by ``make generate``."""

# The types are checked where the conditions are written.
# mypy: ignore-errors

from math import inf as math_inf
from math import pi as math_pi
from pathlib import PurePosixPath as pathlib_PurePosixPath
from sdfcheck import Include as sdfcheck_Include
from sdfcheck import Root as sdfcheck_Root
import math as math_
import os as os_
import re as re_

drk_remote_mesh__SCHEMES = ('http://', 'https://', 'fuel://')

def DRK022_applies(resource):
    return resource.what == 'mesh' and (not resource.is_extension) and resource.uri.startswith(drk_remote_mesh__SCHEMES)

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
    return placed.content if isinstance(placed, sdfcheck_Include) else placed

def FRM004_applies(placed):
    value = placed.placement_frame_value
    if value is None or placed.is_urdf:
        return False
    model, name = (frm_unknown_placement_frame___model(placed), value.text.strip())
    is_kept = name == '__root__' and isinstance(placed, sdfcheck_Include)
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
    return element.attribute('rpy') if element.tag == 'origin' else element.own_value

def frm_degrees_as_radians___says_otherwise(pose):
    if not pose.keys():
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
    if element.tag == 'pose':
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
    if not pose.keys():
        return False
    length = math_.hypot(*frm_non_unit_quaternion___quaternion(pose))
    return abs(length - 1) > frm_non_unit_quaternion___ROUNDING

def FRM008_applies(joint):
    parent, child = (joint.parent, joint.child)
    if joint.is_urdf or parent is None or child is None or (joint.parent_name == joint.child_name):
        return False
    return any((end.carrier is not None and end.carrier.kind == 'model' for end in (parent, child)))

def FRM009_applies(reference):
    return reference.scope is None and reference.owner_element.tag in {'model', 'include'}

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
    if isinstance(part, sdfcheck_Root):
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
    if material.is_urdf or material.is_extension:
        return False
    script = material.script
    uri = None if script is None else script.find('uri')
    return uri is not None and uri.content.strip() in gaz_unset_script_uri__UNSET

def inr_moments__is_remarkable(inertial):
    return not (inertial.is_unremarkable or inertial.is_automatic or inertial.link.may_be_static)

def INR001_applies(inertial):
    if not inr_moments__is_remarkable(inertial):
        return False
    mass = inertial.mass
    return mass.number < 0 or (mass.number == 0 and (not inertial.is_urdf)) or mass.text.lower() == 'nan'

def inr_moments__has_moments(inertial):
    if not inr_moments__is_remarkable(inertial) or not inertial.is_legible:
        return False
    mass = inertial.mass
    return not mass.is_given or mass.number > 0 or '$' in mass.text

inr_moments___ROUNDING = 2.3e-15

def inr_moments__rounding(inertial):
    return inr_moments___ROUNDING * max(map(abs, inertial.tensor))

def inr_moments__is_indefinite(inertial):
    return inertial.principal[0] < -inr_moments__rounding(inertial)

def INR002_applies(inertial):
    return inr_moments__has_moments(inertial) and inr_moments__is_indefinite(inertial)

def inr_moments__is_impossible(inertial):
    low, middle, high = inertial.principal
    return low + middle + inr_moments__rounding(inertial) < high

def INR003_applies(inertial):
    return inr_moments__has_moments(inertial) and inr_moments__is_impossible(inertial) and (not inr_moments__is_indefinite(inertial))

def INR004_applies(link):
    if link.has('inertial') or link.is_urdf or link.may_be_static:
        return False
    return (link.has('collision') or link.has('visual')) and (not link.misspells('inertial'))

def inr_moments__ratio(inertial):
    if not inr_moments__has_moments(inertial) or inr_moments__is_indefinite(inertial) or inr_moments__is_impossible(inertial):
        return math_.nan
    expected, trace = (inertial.solid_trace, inertial.tensor.trace)
    return trace / expected if 0 < expected < math_.inf and 0 < trace < math_.inf else math_.nan

inr_moments___FACTOR = 100.0

def inr_moments__is_about_origin(inertial):
    if inertial.inertia is None or inertial.center is None or (not inr_moments__ratio(inertial) > 10):
        return False
    offset = math_.hypot(*inertial.center)
    shifted = (inertial.tensor.trace - 2 * inertial.mass.number * offset * offset) / inertial.solid_trace
    return offset > 0 and 1 / 3 < shifted < 3

def inr_moments__is_far_off(inertial):
    found = inr_moments__ratio(inertial)
    return (found < 1 / inr_moments___FACTOR or found > inr_moments___FACTOR) and (not inr_moments__is_about_origin(inertial))

def inr_moments__is_unit(inertial):
    return inertial.tensor == (1, 1, 1, 0, 0, 0)

def INR005_applies(inertial):
    return inr_moments__is_far_off(inertial) and inr_moments__is_unit(inertial)

def INR006_applies(inertial):
    return inertial.inertia is not None and inr_moments__is_far_off(inertial) and (not inr_moments__is_unit(inertial))

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
    if inertial.inertia is None or not inr_moments__has_moments(inertial) or any(inertial.tensor):
        return False
    if not (inertial.mass.is_given and inertial.mass.number > 0):
        return False
    link = inertial.link
    return not link.child_joints and (not link.parent_joints) and (link not in inertial.root.parent_joints)

def jnt_unknown_joint_end___joint_name(end):
    joint = end.element.parent
    return '' if joint is None else joint.attributes.get('name', '').strip()

def jnt_unknown_joint_end___unknown_ends(joint):
    if joint.parent is not None and joint.child is not None:
        return []
    parent, child = (joint.parent_value, joint.child_value)
    unknown = [parent] if parent is not None and joint.parent is None else []
    unknown += [child] if child is not None and joint.child is None else []
    if not unknown or joint.is_extension:
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
    if child is None or parent is None or joint.is_extension:
        return False
    if child.text == parent.text:
        return joint.is_urdf or child.text != 'world'
    return joint.child_link is not None and joint.child_link is joint.parent_link

def JNT003_applies(joint):
    if joint.parent_value is None or joint.child_value is None or joint.is_extension:
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
    return not (joint.is_urdf or joint.is_extension) and any((not axis.is_given and (not joint.misspells(name)) for axis, name in zip(joint.axes, ('axis', 'axis2'), strict=False)))

jnt_inverted_limits__BOUNDED = frozenset(('prismatic', 'revolute'))

def JNT005_applies(limit):
    lower, upper = (limit.lower, limit.upper)
    if not lower > upper or not lower.number > upper.number or (not (lower.is_given and upper.is_given)):
        return False
    if limit.is_urdf and (not (limit.joint.type in jnt_inverted_limits__BOUNDED and math_inf > lower.number and (upper.number > -math_inf))):
        return False
    return limit.axis.limit is limit and (not limit.is_extension)

jnt_directions__NO_LENGTH = 1e-06

def jnt_directions__has_no_length(axis):
    return axis.length <= 0 if axis.is_urdf else axis.length < jnt_directions__NO_LENGTH

jnt_directions__WITH_AXIS = frozenset(('continuous', 'planar', 'prismatic', 'revolute'))

def jnt_directions__is_used(axis):
    joint = axis.joint
    if axis.is_extension or (axis is not joint.axis and axis is not joint.axis2):
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
    if value is None or mimic.is_extension or mimic is not mimic.axis.mimic:
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
    if not jnt_negative_limit___negative(part) or part.is_extension:
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
    return bool(jnt_useless_limit___useless(limit)) and limit.axis.limit is limit and (not limit.is_extension)

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

muj_massless_body__LEAST = 1e-15

def muj_massless_body___has_mass(link):
    inertial = link.inertial
    if not inertial.is_given:
        return link.has('collision')
    if not inertial.has('mass') or not inertial.has('inertia'):
        return True
    numbers = [inertial.mass, *(inertial.moments[moment] for moment in ('ixx', 'iyy', 'izz'))]
    return not any((number.is_given and number.number <= muj_massless_body__LEAST for number in numbers))

def muj_massless_body___fused(link):
    found = {link}
    waiting = [link]
    while waiting:
        for joint in waiting.pop().child_joints:
            child = joint.child_link if joint.is_fixed else None
            if child is not None and child not in found:
                found.add(child)
                waiting.append(child)
    return found

def MUJ003_applies(link):
    if not link.is_urdf or not link.parent_joints or (not link.parent_joints[0].moves):
        return False
    return not any(map(muj_massless_body___has_mass, muj_massless_body___fused(link)))

muj_singular_inertia__LEAST = 1e-14

def MUJ004_applies(inertial):
    if not inertial.is_urdf or inertial.is_unremarkable or (not inertial.is_legible):
        return False
    joints = inertial.link.parent_joints
    if inertial.inertia is None or (joints and joints[0].moves):
        return False
    low, middle, high = inertial.principal
    is_body = low + middle >= high * (1 - muj_singular_inertia__LEAST) and low > -muj_singular_inertia__LEAST * high
    return high > 0 and low < muj_singular_inertia__LEAST and is_body

def NAM001_applies(root):
    return any((first.kind == later.kind for first, later in root.names.shared))

def NAM002_applies(root):
    return any((first.kind != later.kind for first, later in root.names.shared))

nam_reserved_name___ROOT = '__root__'

def nam_reserved_name___is_reserved(name, root):
    text = name.name
    is_word = text == 'world' and (not root.is_urdf)
    is_framed = len(text) >= 4 and text.startswith('__') and text.endswith('__')
    return (is_word or is_framed) and name.is_compared

def NAM003_applies(root):
    is_referred_to = nam_reserved_name___ROOT in root.document.source.text
    return is_referred_to or any((nam_reserved_name___is_reserved(name, root) for name in root.names.special))

def nam_delimiter_in_name___is_divided(name):
    return '::' in name.name and ':' not in name.kind and (name.kind != 'material')

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

def NS009_applies(custom):
    return bool(custom.displaced)

def NS010_applies(custom):
    return bool(custom.replaced)

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

def RES006_applies(named):
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

def RES011_applies(part):
    return bool(part.unresolved)

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
    return not any((ancestor.tag == 'state' for ancestor in element.iterancestors()))

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
        is_empty = len(geometry) == 0 or next(geometry.children(), None) is None
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
    if not expected or sensor.root.is_urdf or any((sensor.misspells(name) for name in expected)):
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

def URD013_applies(robot):
    lumping = robot.lumping
    return not lumping.with_mass.issuperset(lumping.tops)

def urd_massless_moving_link__is_apart(link):
    joint = link.parent_joints[0]
    return joint.moves or joint.is_preserved

def urd_massless_moving_link__dropped(robot):
    lumping = robot.lumping
    found = []
    for top in lumping.tops:
        members = list(top.below())
        if any((link.has_mass for link in members)):
            found += [link for link in members[1:] if link not in lumping.with_mass and urd_massless_moving_link__is_apart(link)]
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

def urd_delimiter_in_extension__delimited(block):
    named = (element.attribute('name') for element in block.all_elements() if element.name != 'plugin')
    return [value for value in named if value is not None and '::' in value.text]

def URD017_applies(block):
    return '::' in block.document.source.text and bool(urd_delimiter_in_extension__delimited(block))

def URD018_applies(mimic):
    return not mimic.joint.is_fixed and mimic.leader is not None and mimic.leader.is_fixed

def URD020_applies(joint):
    return joint.type in ('floating', 'planar')

xml_missing_root__OLD = 'gazebo'

xml_missing_root__FORGOTTEN = frozenset({'model', 'world', xml_missing_root__OLD})

def XML011_applies(root):
    return not root.is_urdf and root.element.name in xml_missing_root__FORGOTTEN and (root.document.kind.value == 'sdf')

CONDITIONS = {
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
    'INR001': INR001_applies,
    'INR002': INR002_applies,
    'INR003': INR003_applies,
    'INR004': INR004_applies,
    'INR005': INR005_applies,
    'INR006': INR006_applies,
    'INR007': INR007_applies,
    'INR008': INR008_applies,
    'INR009': INR009_applies,
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
    'MUJ001': MUJ001_applies,
    'MUJ002': MUJ002_applies,
    'MUJ003': MUJ003_applies,
    'MUJ004': MUJ004_applies,
    'NAM001': NAM001_applies,
    'NAM002': NAM002_applies,
    'NAM003': NAM003_applies,
    'NAM004': NAM004_applies,
    'NAM005': NAM005_applies,
    'NAM007': NAM007_applies,
    'NS009': NS009_applies,
    'NS010': NS010_applies,
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
    'SCH001': SCH001_applies,
    'SCH002': SCH002_applies,
    'SCH016': SCH016_applies,
    'SCH018': SCH018_applies,
    'SCH021': SCH021_applies,
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
    'XML011': XML011_applies,
}
