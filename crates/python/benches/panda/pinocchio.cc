// m̄ of one contact with its own point and normal at each of many configurations, by Pinocchio: M by CRBA, the Jacobian of the link,
// and a Cholesky solution. Reads model.urdf, then N rows of nq positions, 3 numbers of the point and 3 of the normal (raw doubles);
// writes N effective masses. Prints the least CPU time of the runs, s.
//
//   pinocchio MODEL.urdf LINK ROWS OUTPUT RUNS
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/parsers/urdf.hpp>

#include <Eigen/Cholesky>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <vector>

static double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

int main(int argc, char **argv)
{
  if (argc != 6) return 2;
  pinocchio::Model model;
  pinocchio::urdf::buildModel(argv[1], model);
  pinocchio::Data data(model);
  const auto frame = model.getFrameId(argv[2], pinocchio::BODY);
  const auto joint = model.frames[frame].parentJoint;
  const auto placement = model.frames[frame].placement;
  std::ifstream file(argv[3], std::ios::binary);
  std::vector<double> values((std::istreambuf_iterator<char>(file)), {}), masses;
  file.clear();
  file.seekg(0, std::ios::end);
  const std::size_t bytes = std::size_t(file.tellg()), width = std::size_t(model.nq) + 6, count = bytes / (8 * width);
  values.resize(count * width);
  file.seekg(0);
  file.read(reinterpret_cast<char *>(values.data()), std::streamsize(bytes));
  masses.resize(count);
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, model.nv);
  Eigen::LLT<Eigen::MatrixXd> cholesky(model.nv);
  Eigen::VectorXd row(model.nv), q(model.nq);
  double least = 1e300;
  for (int run = 0; run < std::atoi(argv[5]); run++) {
    const double start = cpu_seconds();
    for (std::size_t k = 0; k < count; k++) {
      const double *at = &values[k * width];
      q = Eigen::Map<const Eigen::VectorXd>(at, model.nq);
      const Eigen::Map<const Eigen::Vector3d> point(at + model.nq), normal(at + model.nq + 3);
      // Fills the Jacobians of all joints too.
      pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
      jacobian.setZero();
      pinocchio::getJointJacobian(model, data, joint, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
      const pinocchio::SE3 link = data.oMi[joint] * placement;
      const Eigen::Vector3d direction = (link.rotation() * normal).normalized();
      const Eigen::Vector3d arm = link.act(Eigen::Vector3d(point)) - data.oMi[joint].translation();
      row.noalias() = jacobian.topRows<3>().transpose() * direction + jacobian.bottomRows<3>().transpose() * arm.cross(direction);
      data.M.triangularView<Eigen::StrictlyLower>() = data.M.transpose().triangularView<Eigen::StrictlyLower>();
      cholesky.compute(data.M);
      masses[k] = 1.0 / row.dot(cholesky.solve(row));
    }
    least = std::min(least, cpu_seconds() - start);
  }
  std::ofstream(argv[4], std::ios::binary).write(reinterpret_cast<const char *>(masses.data()), std::streamsize(8 * count));
  std::printf("%.9f\n", least);
}
