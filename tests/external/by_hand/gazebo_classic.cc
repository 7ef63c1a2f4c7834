// Impacts in Gazebo Classic 11: a world file with models "struck0", "struck1", …, whose links "link" hit an obstacle.
//
//   gazebo_classic WORLD ITERATIONS SPEED LEVER GAP..
//   Each link's point (LEVER, 0, 0) touches when it is GAP below its initial position; it moves down at SPEED, and
//   rotates about the link's origin if LEVER is not 0. Output: a line per link with rebound speed over SPEED, deepest
//   penetration.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gazebo/gazebo.hh>
#include <gazebo/physics/physics.hh>

int main(int count, char **words) {
  if (count < 6) return 2;
  const unsigned int iterations = std::atoi(words[2]);
  const double v = std::atof(words[3]), lever = std::atof(words[4]);
  gazebo::setupServer(std::vector<std::string>{});
  auto world = gazebo::loadWorld(words[1]);
  if (!world) return 3;
  struct Struck {
    gazebo::physics::LinkPtr link;
    double gap, start, depth = 0, rate = 0;
    bool touched = false, back = false;
  };
  const ignition::math::Vector3d point(lever, 0, 0);
  std::vector<Struck> all;
  for (int i = 5; i < count; i++) {
    auto link = world->ModelByName("struck" + std::to_string(i - 5))->GetLink("link");
    if (lever != 0) link->SetAngularVel({0, v / lever, 0});
    link->SetLinearVel({0, 0, lever != 0 ? -v / lever * link->GetInertial()->CoG().X() : -v});
    all.push_back({link, std::atof(words[i]), (link->WorldPose().Rot() * point + link->WorldPose().Pos()).Z()});
  }
  auto connection = gazebo::event::Events::ConnectWorldUpdateEnd([&] {
    for (auto &s : all) {
      if (s.back) continue;
      const double height = (s.link->WorldPose().Rot() * point + s.link->WorldPose().Pos()).Z() - s.start + s.gap;
      s.rate = s.link->WorldLinearVel(point).Z();
      s.depth = std::max(s.depth, -height);
      s.touched |= height < 0;
      s.back = s.touched && height > 0 && s.rate > 0;
    }
  });
  gazebo::runWorld(world, iterations);
  for (const auto &s : all) std::printf("%.17g %.17g\n", s.rate / v, s.depth);
  std::fflush(stdout);
  std::_Exit(0);
}
