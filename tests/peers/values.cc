// What libsdformat reads from files: a line for each value, "file key numbers-or-text", to stdout.
// Values are those of its object model, so defaults are in it and poses are resolved.

#include <sdf/sdf.hh>
#include <sys/wait.h>
#include <unistd.h>
#include <cstdio>
#include <iostream>
#include <string>

using ignition::math::Pose3d;

static std::string file;

static void put(const std::string &key, std::initializer_list<double> values) {
  std::printf("%s\t%s", file.c_str(), key.c_str());
  for (double value : values) std::printf("\t%.17g", value);
  std::printf("\n");
}

static void put(const std::string &key, const std::string &text) {
  std::printf("%s\t%s\t=%s\n", file.c_str(), key.c_str(), text.c_str());
}

static void pose(const std::string &key, const sdf::SemanticPose &semantic, const std::string &to) {
  Pose3d found;
  if (semantic.Resolve(found, to).empty())
    put(key + "/pose", {found.Pos().X(), found.Pos().Y(), found.Pos().Z(), found.Rot().X(), found.Rot().Y(),
                        found.Rot().Z(), found.Rot().W()});
}

static void geometry(const std::string &key, const sdf::Geometry &shape) {
  if (auto box = shape.BoxShape()) put(key + "/box", {box->Size().X(), box->Size().Y(), box->Size().Z()});
  if (auto sphere = shape.SphereShape()) put(key + "/sphere", {sphere->Radius()});
  if (auto cylinder = shape.CylinderShape()) put(key + "/cylinder", {cylinder->Radius(), cylinder->Length()});
  if (auto capsule = shape.CapsuleShape()) put(key + "/capsule", {capsule->Radius(), capsule->Length()});
  if (auto round = shape.EllipsoidShape())
    put(key + "/ellipsoid", {round->Radii().X(), round->Radii().Y(), round->Radii().Z()});
  if (auto mesh = shape.MeshShape()) {
    put(key + "/mesh", {mesh->Scale().X(), mesh->Scale().Y(), mesh->Scale().Z()});
    put(key + "/uri", mesh->Uri());
  }
}

static void color(const std::string &key, const ignition::math::Color &c) { put(key, {c.R(), c.G(), c.B(), c.A()}); }

static void sensor(const std::string &key, const sdf::Sensor &found, const std::string &link) {
  put(key + "/type", found.TypeStr());
  put(key + "/update_rate", {found.UpdateRate()});
  pose(key, found.SemanticPose(), link);
}

static void link(const std::string &key, const sdf::Link &found) {
  pose(key, found.SemanticPose(), "__model__");
  const auto &body = found.Inertial();
  const auto &mass = body.MassMatrix();
  const auto &at = body.Pose();
  put(key + "/mass", {mass.Mass()});
  put(key + "/moments", {mass.Ixx(), mass.Iyy(), mass.Izz(), mass.Ixy(), mass.Ixz(), mass.Iyz()});
  put(key + "/center", {at.Pos().X(), at.Pos().Y(), at.Pos().Z()});
  const auto moi = body.Moi();
  put(key + "/moi", {moi(0, 0), moi(0, 1), moi(0, 2), moi(1, 1), moi(1, 2), moi(2, 2)});
  for (uint64_t i = 0; i < found.VisualCount(); ++i) {
    auto visual = found.VisualByIndex(i);
    auto own = key + "/visual:" + visual->Name();
    pose(own, visual->SemanticPose(), found.Name());
    geometry(own, *visual->Geom());
    if (auto material = visual->Material()) {
      if (!material->Element()) continue;
      for (auto name : {"ambient", "diffuse", "specular", "emissive"})
        if (material->Element()->HasElement(name))
          color(own + "/" + name, std::string(name) == "ambient"    ? material->Ambient()
                                  : std::string(name) == "diffuse"  ? material->Diffuse()
                                  : std::string(name) == "specular" ? material->Specular()
                                                                    : material->Emissive());
    }
  }
  for (uint64_t i = 0; i < found.CollisionCount(); ++i) {
    auto collision = found.CollisionByIndex(i);
    auto own = key + "/collision:" + collision->Name();
    pose(own, collision->SemanticPose(), found.Name());
    geometry(own, *collision->Geom());
  }
  for (uint64_t i = 0; i < found.SensorCount(); ++i) {
    auto one = found.SensorByIndex(i);
    sensor(key + "/sensor:" + one->Name(), *one, found.Name());
  }
}

static void joint(const std::string &key, const sdf::Joint &found) {
  pose(key, found.SemanticPose(), "__model__");
  for (unsigned int i = 0; i < 2; ++i)
    if (auto axis = found.Axis(i)) {
      auto own = key + (i ? "/axis2" : "/axis");
      ignition::math::Vector3d xyz;
      if (axis->ResolveXyz(xyz, found.Name()).empty()) put(own + "/xyz", {xyz.X(), xyz.Y(), xyz.Z()});
      put(own + "/limits", {axis->Lower(), axis->Upper(), axis->Effort(), axis->MaxVelocity()});
      put(own + "/dynamics", {axis->Damping(), axis->Friction(), axis->SpringReference(), axis->SpringStiffness()});
    }
  for (uint64_t i = 0; i < found.SensorCount(); ++i) {
    auto one = found.SensorByIndex(i);
    sensor(key + "/sensor:" + one->Name(), *one, found.Name());
  }
}

static void model(const std::string &prefix, const sdf::Model &found) {
  auto key = prefix + found.Name();
  put(key + "/static", {double(found.Static())});
  for (uint64_t i = 0; i < found.LinkCount(); ++i)
    link(key + "/link:" + found.LinkByIndex(i)->Name(), *found.LinkByIndex(i));
  for (uint64_t i = 0; i < found.JointCount(); ++i)
    joint(key + "/joint:" + found.JointByIndex(i)->Name(), *found.JointByIndex(i));
  for (uint64_t i = 0; i < found.ModelCount(); ++i) model(key + "::", *found.ModelByIndex(i));
}

static void read() {
  sdf::Root root;
  auto errors = root.Load(file);
  if (errors.empty() && root.Model()) model("", *root.Model());
  for (uint64_t w = 0; errors.empty() && w < root.WorldCount(); ++w)
    for (uint64_t m = 0; m < root.WorldByIndex(w)->ModelCount(); ++m)
      model("", *root.WorldByIndex(w)->ModelByIndex(m));
  put("errors", {double(errors.size())});
}

// The library may crash: each file has a process of its own.
int main(int count, char **arguments) {
  sdf::SDFPtr description(new sdf::SDF());
  sdf::init(description);
  for (int i = 1; i < count; ++i) {
    if (pid_t child = fork()) {
      waitpid(child, nullptr, 0);
      continue;
    }
    file = arguments[i];
    read();
    std::fflush(stdout);
    _exit(0);
  }
  _exit(0);
}
