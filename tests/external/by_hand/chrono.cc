// Impacts in Project Chrono's smooth contacts (ChSystemSMC), shapes and collisions by Chrono too.
//
//   chrono MODEL FIRST SECOND TIME_STEP SPEED SOLVER FRICTION WALL SCENE NUMBERS.. GAP..
//   chrono --version
//   MODEL hooke: FIRST is kn, SECOND gn; hertz: FIRST is the modulus E_eff (on Chrono's radius of 0.1 m), SECOND the restitution.
//   SOLVER default, or lu, qr: direct ones. FRICTION negative: the material's default. WALL: the fixed body's mass, kg; 0: its default.
//   SCENE and NUMBERS:
//     ball MASS RADIUS
//     pendulum MASS CENTRE OFFSET INERTIA_ABOUT_CENTRE LEVER RADIUS
//     four-bar RADIUS X Y, three bodies: MASS INERTIA X Y VX VY RATE, four hinges: BODY BODY X Y (-1: the ground)
//   For each GAP (m, at the start) a line: speed of rebound over SPEED, deepest penetration.
//
// The places of the linkage are moved so that the contact is at the origin: collisions are found in single precision.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "chrono/ChVersion.h"
#include "chrono/collision/ChCollisionShapeBox.h"
#include "chrono/collision/ChCollisionShapeSphere.h"
#include "chrono/physics/ChBody.h"
#include "chrono/physics/ChContactMaterialSMC.h"
#include "chrono/physics/ChLinkMate.h"
#include "chrono/physics/ChSystemSMC.h"

using namespace chrono;

enum { BODIES = 3, HINGES = 4, STRUCK = 1, CLOSES = 2, FOUR_BAR = 3 + 7 * BODIES + 4 * HINGES };
// Steps that are waited for the end of an impact.
const long LONGEST = 3000000;

int main(int count, char **words) {
  if (count == 2 && !std::strcmp(words[1], "--version")) {
    std::printf("%s\n", CHRONO_VERSION);
    return 0;
  }
  if (count < 11) return 2;
  const std::string model = words[1], solver = words[6], scene = words[9];
  const double first = std::atof(words[2]), second = std::atof(words[3]), h = std::atof(words[4]), v = std::atof(words[5]);
  const double friction = std::atof(words[7]), wall_mass = std::atof(words[8]);
  const int numbers = scene == "ball" ? 2 : scene == "pendulum" ? 6 : FOUR_BAR;
  const double *n;
  std::vector<double> given;
  for (int i = 10; i < count; i++) given.push_back(std::atof(words[i]));
  n = given.data();
  for (int at = numbers; at < (int)given.size(); at++) {
    const double gap = given[at];
    ChSystemSMC system;
    system.SetGravitationalAcceleration(ChVector3d(0, 0, 0));
    system.SetCollisionSystemType(ChCollisionSystem::Type::BULLET);
    auto material = chrono_types::make_shared<ChContactMaterialSMC>();
    if (model == "hooke") {
      system.UseMaterialProperties(false);
      system.SetContactForceModel(ChSystemSMC::Hooke);
      material->SetKn((float)first);
      material->SetGn((float)second);
    } else {
      system.UseMaterialProperties(true);
      system.SetContactForceModel(ChSystemSMC::Hertz);
      material->SetPoissonRatio(0.3f);
      material->SetYoungModulus((float)(2 * (1 - 0.3 * 0.3) * first));
      material->SetRestitution((float)second);
    }
    if (friction >= 0) material->SetFriction((float)friction);
    if (solver == "lu") system.SetSolverType(ChSolver::Type::SPARSE_LU);
    if (solver == "qr") system.SetSolverType(ChSolver::Type::SPARSE_QR);

    // A body with its centre of mass at (x, y, z), inertia about it the same for all axes.
    auto body = [&](double mass, double inertia, double x, double y, double z) {
      auto made = chrono_types::make_shared<ChBody>();
      made->SetMass(mass);
      made->SetInertiaXX(ChVector3d(inertia, inertia, inertia));
      made->SetPos(ChVector3d(x, y, z));
      system.AddBody(made);
      return made;
    };
    auto sphere = [&](std::shared_ptr<ChBody> of, double radius, ChVector3d place) {
      auto shape = chrono_types::make_shared<ChCollisionShapeSphere>(material, radius);
      of->AddCollisionShape(shape, ChFrame<>(place));
      of->EnableCollision(true);
    };
    // A box of 2 m, its upper face at z = top.
    auto wall = chrono_types::make_shared<ChBody>();
    wall->SetFixed(true);
    if (wall_mass > 0) wall->SetMass(wall_mass);
    auto floor = [&](double top) {
      wall->AddCollisionShape(chrono_types::make_shared<ChCollisionShapeBox>(material, 2, 2, 2), ChFrame<>(ChVector3d(0, 0, top - 1)));
      wall->EnableCollision(true);
      system.AddBody(wall);
    };
    auto ground = chrono_types::make_shared<ChBody>();
    ground->SetFixed(true);
    system.AddBody(ground);
    // All hinges are along y; `held`: without the rows that hold the bodies in the plane.
    auto hinge = [&](std::shared_ptr<ChBody> a, std::shared_ptr<ChBody> b, ChVector3d place, bool held) {
      auto made = chrono_types::make_shared<ChLinkMateGeneric>(true, true, !held, !held, !held, false);
      made->Initialize(a, b, ChFrame<>(place, QuatFromAngleX(CH_PI_2)));
      system.AddLink(made);
    };

    std::shared_ptr<ChBody> struck;
    ChVector3d point(0, 0, 0);
    if (scene == "ball") {
      struck = body(n[0], 0.4 * n[0] * n[1] * n[1], 0, 0, gap);
      sphere(struck, n[1], point);
      floor(-n[1]);
      struck->SetPosDt(ChVector3d(0, 0, -v));
    } else if (scene == "pendulum") {
      // The hinge is at (−lever, 0, 0).
      const double centre = n[1], offset = n[2], lever = n[4], radius = n[5];
      struck = body(n[0], n[3], centre - lever, 0, offset);
      point = ChVector3d(lever - centre, 0, -offset);
      sphere(struck, radius, point);
      hinge(struck, ground, ChVector3d(-lever, 0, 0), false);
      floor(-radius - gap);
      struck->SetPosDt(ChVector3d(v / lever * offset, 0, -v / lever * centre));
      struck->SetAngVelParent(ChVector3d(0, v / lever, 0));
    } else {
      // What is drawn along y is along z, and a turn about z is one about −y.
      const double *b = n + 3, *j = b + 7 * BODIES, radius = n[0], x = n[1], y = n[2];
      std::shared_ptr<ChBody> made[BODIES];
      for (int i = 0; i < BODIES; i++, b += 7) {
        made[i] = body(b[0], b[1], b[2] - x, 0, b[3] - y);
        made[i]->SetPosDt(ChVector3d(b[4], 0, b[5]));
        made[i]->SetAngVelParent(ChVector3d(0, -b[6], 0));
      }
      for (int i = 0; i < HINGES; i++, j += 4)
        hinge(made[(int)j[0]], j[1] < 0 ? ground : made[(int)j[1]], ChVector3d(j[2] - x, 0, j[3] - y), i == CLOSES);
      struck = made[STRUCK];
      point = -struck->GetPos();
      sphere(struck, radius, point);
      floor(-radius - gap);
    }

    double depth = 0, rate = 0;
    bool touched = false, back = false;
    const double level = scene == "ball" ? 0 : -gap;
    for (long i = 0; i < LONGEST && !back; i++) {
      system.DoStepDynamics(h);
      const double height = struck->TransformPointLocalToParent(point).z() - level;
      rate = struck->PointSpeedLocalToParent(point).z();
      depth = std::max(depth, -height);
      touched |= height < 0;
      back = touched && height > 0 && rate > 0;
      if (!std::isfinite(height)) break;
    }
    std::printf("%.17g %.17g\n", back ? rate / v : NAN, depth);
  }
}
