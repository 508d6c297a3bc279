// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CageShapes.h"

namespace test
{
hexsweep::TriangleMesh tetrahedron()
{
  hexsweep::TriangleMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0.1, 0, 0, 1, 0.2, 0.1, 0.3, 1, 0, 0.4, 0.3, 1;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  return mesh;
}

hexsweep::TriangleMesh angleBlock()
{
  hexsweep::TriangleMesh mesh;
  mesh.points.resize(16, 3);
  const double plan[8][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 },
    { 0, 1 } };
  for (Index i = 0; i < 16; ++i)
  {
    mesh.points.row(i) << plan[i % 8][0], plan[i % 8][1], static_cast<double>(i / 8);
  }
  const Index squares[3][4] = { { 0, 1, 4, 7 }, { 1, 2, 3, 4 }, { 7, 4, 5, 6 } };
  mesh.triangles.resize(28, 3);
  Index t = 0;
  for (const auto& s : squares)
  {
    mesh.triangles.row(t++) << s[0], s[2], s[1];
    mesh.triangles.row(t++) << s[0], s[3], s[2];
    mesh.triangles.row(t++) << s[0] + 8, s[1] + 8, s[2] + 8;
    mesh.triangles.row(t++) << s[0] + 8, s[2] + 8, s[3] + 8;
  }
  for (Index i = 0; i < 8; ++i)
  {
    const Index next = (i + 1) % 8;
    mesh.triangles.row(t++) << i, next, next + 8;
    mesh.triangles.row(t++) << i, next + 8, i + 8;
  }
  return mesh;
}

hexsweep::TriangleMesh moved(hexsweep::TriangleMesh mesh, const Eigen::Affine3d& motion)
{
  mesh.points =
    (mesh.points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
  return mesh;
}

Eigen::Affine3d similarity(double scale)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.linear() =
    scale * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  motion.translation() = scale * Eigen::Vector3d(0.4, -1.1, 0.3);
  return motion;
}

Points insideAngleBlock()
{
  Points points(9, 3);
  points << 0.31, 0.42, 0.53, 1.6, 0.5, 0.3, 0.2, 1.7, 0.8, 0.9, 0.9, 0.1, 1.3, 0.02, 0.6, 0.7, 1.1,
    0.999, 1.4, 0.9, 0.5, 1.0, 0.5, 0.5, 0.4, 1.0, 0.25;
  return points;
}

double integrate(const Eigen::Matrix3d& corners, const Eigen::RowVector3d& x,
  const TriangleFunction& f, const Eigen::Matrix3d& part)
{
  const Eigen::Matrix3d places = part * corners;
  const Eigen::RowVector3d u = places.row(1) - places.row(0);
  const Eigen::RowVector3d v = places.row(2) - places.row(0);
  const double size = std::max({ u.norm(), v.norm(), (v - u).norm() });
  const double distance = (places.colwise().mean() - x).norm();
  if (size > 0.3 * distance)
  {
    const Eigen::RowVector3d a = 0.5 * (part.row(1) + part.row(2));
    const Eigen::RowVector3d b = 0.5 * (part.row(2) + part.row(0));
    const Eigen::RowVector3d c = 0.5 * (part.row(0) + part.row(1));
    double sum = 0.0;
    Eigen::Matrix3d child;
    child << part.row(0), c, b;
    sum += integrate(corners, x, f, child);
    child << c, part.row(1), a;
    sum += integrate(corners, x, f, child);
    child << b, a, part.row(2);
    sum += integrate(corners, x, f, child);
    child << a, b, c;
    return sum + integrate(corners, x, f, child);
  }
  const double root = std::sqrt(15.0);
  double sum = 9.0 / 40.0 * f(places.colwise().mean(), part.colwise().mean());
  for (const double sign : { -1.0, 1.0 })
  {
    const double near = (6.0 + sign * root) / 21.0;
    const double weight = (155.0 + sign * root) / 1200.0;
    for (int c = 0; c < 3; ++c)
    {
      Eigen::RowVector3d place = Eigen::RowVector3d::Constant(near);
      place[c] = 1.0 - 2.0 * near;
      sum += weight * f(place * places, place * part);
    }
  }
  return 0.5 * u.cross(v).norm() * sum;
}
}
