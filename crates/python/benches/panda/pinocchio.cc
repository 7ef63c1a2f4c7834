// m̄ of one contact with its own point and normal at each of many configurations, by Pinocchio: M by CRBA, the Jacobian of the link,
// and a Cholesky solution. Uses the headers alone, so that all of Pinocchio is compiled for this processor. Reads a model (panda.py
// writes it) and N rows of nq positions, 3 numbers of the point and 3 of the normal (raw doubles); writes N effective masses. Prints
// the least CPU time of the runs, s.
//
//   pinocchio MODEL ROWS OUTPUT RUNS
#include <pinocchio/multibody.hpp>

#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>

#include <Eigen/Cholesky>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

static double cpu_seconds()
{
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

static pinocchio::SE3 placement(std::istream &in)
{
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int k = 0; k < 9; k++) in >> rotation(k / 3, k % 3);
  for (int k = 0; k < 3; k++) in >> translation[k];
  return pinocchio::SE3(rotation, translation);
}

// Number of the contact link's joint and its placement there; then each joint: kind, parent, axis, placement, mass, centre, inertia about it.
static pinocchio::Model read_model(std::istream &in, pinocchio::JointIndex &joint, pinocchio::SE3 &link)
{
  pinocchio::Model model;
  std::size_t parent;
  std::string kind;
  in >> joint;
  link = placement(in);
  while (in >> kind >> parent) {
    Eigen::Vector3d axis;
    for (int k = 0; k < 3; k++) in >> axis[k];
    pinocchio::JointModel made;
    if (kind == "JointModelRX") made = pinocchio::JointModelRX();
    else if (kind == "JointModelRY") made = pinocchio::JointModelRY();
    else if (kind == "JointModelRZ") made = pinocchio::JointModelRZ();
    else if (kind == "JointModelPY") made = pinocchio::JointModelPY();
    else if (kind == "JointModelPrismaticUnaligned") made = pinocchio::JointModelPrismaticUnaligned(axis);
    else std::exit(3);
    const pinocchio::SE3 origin = placement(in);
    double mass;
    Eigen::Vector3d com;
    Eigen::Matrix3d inertia;
    in >> mass;
    for (int k = 0; k < 3; k++) in >> com[k];
    for (int k = 0; k < 9; k++) in >> inertia(k / 3, k % 3);
    const auto index = model.addJoint(parent, made, origin, "joint " + std::to_string(model.njoints));
    model.appendBodyToJoint(index, pinocchio::Inertia(mass, com, inertia), pinocchio::SE3::Identity());
  }
  return model;
}

int main(int argc, char **argv)
{
  if (argc != 5) return 2;
  std::ifstream text(argv[1]);
  pinocchio::JointIndex joint;
  pinocchio::SE3 placed;
  pinocchio::Model model = read_model(text, joint, placed);
  pinocchio::Data data(model);
  std::ifstream file(argv[2], std::ios::binary);
  file.seekg(0, std::ios::end);
  const std::size_t width = std::size_t(model.nq) + 6, count = std::size_t(file.tellg()) / (8 * width);
  std::vector<double> values(count * width), masses(count);
  file.seekg(0);
  file.read(reinterpret_cast<char *>(values.data()), std::streamsize(8 * values.size()));
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, model.nv);
  Eigen::LLT<Eigen::MatrixXd> cholesky(model.nv);
  Eigen::VectorXd row(model.nv), q(model.nq);
  double least = 1e300;
  for (int run = 0; run < std::atoi(argv[4]); run++) {
    const double start = cpu_seconds();
    for (std::size_t k = 0; k < count; k++) {
      const double *at = &values[k * width];
      q = Eigen::Map<const Eigen::VectorXd>(at, model.nq);
      const Eigen::Map<const Eigen::Vector3d> point(at + model.nq), normal(at + model.nq + 3);
      // Fills the Jacobians of all joints too.
      pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
      jacobian.setZero();
      pinocchio::getJointJacobian(model, data, joint, pinocchio::LOCAL_WORLD_ALIGNED, jacobian);
      const pinocchio::SE3 link = data.oMi[joint] * placed;
      const Eigen::Vector3d direction = (link.rotation() * normal).normalized();
      const Eigen::Vector3d arm = link.act(Eigen::Vector3d(point)) - data.oMi[joint].translation();
      row.noalias() = jacobian.topRows<3>().transpose() * direction + jacobian.bottomRows<3>().transpose() * arm.cross(direction);
      data.M.triangularView<Eigen::StrictlyLower>() = data.M.transpose().triangularView<Eigen::StrictlyLower>();
      cholesky.compute(data.M);
      masses[k] = 1.0 / row.dot(cholesky.solve(row));
    }
    least = std::min(least, cpu_seconds() - start);
  }
  std::ofstream(argv[3], std::ios::binary).write(reinterpret_cast<const char *>(masses.data()), std::streamsize(8 * count));
  std::printf("%.9f\n", least);
}
