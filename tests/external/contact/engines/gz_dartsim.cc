// Impacts in new Gazebo's physics: the dartsim plugin of gz-physics (here ign-physics 5).
//
//   gz_dartsim PLUGIN TIME_STEP SPEED LEVER SDF..
//   Each SDF has a model "struck": a link "link" that touches an obstacle at z = 0 (LEVER 0), or a joint "hinge" with
//   angle 0 at the touch, approached at -SPEED/LEVER. Output: a line per SDF with rebound speed over SPEED, deepest
//   observed penetration.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <ignition/physics/ForwardStep.hh>
#include <ignition/physics/FrameSemantics.hh>
#include <ignition/physics/FreeGroup.hh>
#include <ignition/physics/GetEntities.hh>
#include <ignition/physics/Joint.hh>
#include <ignition/physics/RequestEngine.hh>
#include <ignition/physics/sdf/ConstructWorld.hh>
#include <ignition/plugin/Loader.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

namespace physics = ignition::physics;

struct Wanted : physics::FeatureList<
                    physics::sdf::ConstructSdfWorld, physics::ForwardStep, physics::GetModelFromWorld,
                    physics::GetLinkFromModel, physics::GetJointFromModel, physics::LinkFrameSemantics,
                    physics::GetBasicJointState, physics::SetBasicJointState, physics::FindFreeGroupFeature,
                    physics::SetFreeGroupWorldVelocity> {};

int main(int count, char **words) {
  if (count < 6) return 2;
  ignition::plugin::Loader loader;
  loader.LoadLib(words[1]);
  const double h = std::atof(words[2]), v = std::atof(words[3]), lever = std::atof(words[4]);
  for (int at = 5; at < count; at++) {
    auto engine = physics::RequestEngine3d<Wanted>::From(loader.Instantiate("ignition::physics::dartsim::Plugin"));
    sdf::Root root;
    for (const auto &error : root.Load(words[at])) std::fprintf(stderr, "%s\n", error.Message().c_str());
    auto world = engine->ConstructWorld(*root.WorldByIndex(0));
    auto model = world->GetModel("struck");
    auto link = model->GetLink("link");
    auto joint = lever > 0 ? model->GetJoint("hinge") : nullptr;
    if (joint)
      joint->SetVelocity(0, -v / lever);
    else
      model->FindFreeGroup()->SetWorldLinearVelocity(Eigen::Vector3d(0, 0, -v));
    physics::ForwardStep::Output output;
    physics::ForwardStep::State state;
    physics::ForwardStep::Input input;
    input.Get<std::chrono::steady_clock::duration>() =
        std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(h));
    double depth = 0, rate = 0;
    bool back = false;
    for (int i = 0; i < 200000 && !back; i++) {
      world->Step(output, state, input);
      double height;
      if (joint) {
        height = lever * joint->GetPosition(0), rate = lever * joint->GetVelocity(0);
      } else {
        const auto frame = link->FrameDataRelativeToWorld();
        height = frame.pose.translation().z(), rate = frame.linearVelocity.z();
      }
      depth = std::max(depth, -height);
      back = depth > 0 && rate >= 0 && i > 4;
    }
    std::printf("%.17g %.17g\n", rate / v, depth);
  }
}
