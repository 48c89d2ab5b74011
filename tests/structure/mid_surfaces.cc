// SPDX-License-Identifier: LGPL-2.1-or-later

// Distances and crossings of mid-surfaces, closed surfaces around shells, and
// forces that another program gives.

#include "../support/run_scene.h"

#include <geometry/mesh_maker.h>
#include <structure/mid_surfaces.h>
#include <structure/shell_body.h>

#include <cmath>
#include <map>
#include <vector>

using namespace Test;

namespace
{
  constexpr double thickness = 0.1;

  /// A square of triangles in a part of its own; corner and directions.
  void
  add_square(std::vector<MidTriangle> &triangles,
             const Point<3>           &corner,
             const Tensor<1, 3>       &a,
             const Tensor<1, 3>       &b,
             const unsigned int        n)
  {
    const unsigned int part = triangles.empty() ? 0 : triangles.back().part + 1;
    const types::global_dof_index first =
      triangles.empty() ? 0 : 1 + triangles.back().dofs[2][2];
    const auto vertex = [&](const unsigned int i, const unsigned int j) {
      return std::make_pair(first + 3 * (j * (n + 1) + i),
                            corner + double(i) / n * a + double(j) / n * b);
    };
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (const bool upper : {false, true})
          {
            MidTriangle t;
            t.thickness = thickness;
            t.part      = part;
            const std::array<std::pair<types::global_dof_index, Point<3>>, 3>
              corners = {{upper ? vertex(i + 1, j) : vertex(i, j),
                          upper ? vertex(i, j + 1) : vertex(i + 1, j),
                          upper ? vertex(i + 1, j + 1) : vertex(i, j + 1)}};
            for (unsigned int k = 0; k < 3; ++k)
              {
                t.dofs[k] = {{corners[k].first,
                              corners[k].first + 1,
                              corners[k].first + 2}};
                t.x[k]    = corners[k].second;
              }
            triangles.push_back(t);
          }
  }

  MidSurfaces::State
  state_of(const std::vector<MidTriangle> &triangles)
  {
    types::global_dof_index last = 0;
    for (const MidTriangle &t : triangles)
      for (const auto &dofs : t.dofs)
        last = std::max(last, dofs[2]);
    return MidSurfaces(triangles, MPI_COMM_WORLD)
      .state(Vector<double>(last + 1));
  }

  const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
} // namespace


TEST(MidSurfaces, DistancesOfFacesEdgesAndCornersAreExact)
{
  const double gap = 0.07;
  const auto   distance =
    [&](const Point<3> &corner, const Tensor<1, 3> &a, const Tensor<1, 3> &b) {
      std::vector<MidTriangle> triangles;
      add_square(triangles, Point<3>(), x, y, 5);
      add_square(triangles, corner, a, b, 7);
      const auto state = state_of(triangles);
      EXPECT_EQ(state.n_crossing, 0u);
      return state.distance * thickness;
    };
  // a face above the face, an edge above it, beside its edge, a corner
  EXPECT_NEAR(distance(Point<3>(0.1, 0.2, gap), x, y), gap, 1e-14);
  EXPECT_NEAR(distance(Point<3>(0.1, 0.2, gap), x, z), gap, 1e-14);
  EXPECT_NEAR(distance(Point<3>(1. + gap, -0.3, -0.5), y, z), gap, 1e-14);
  EXPECT_NEAR(distance(Point<3>(0.5, 0.5, gap), x + z, y + z), gap, 1e-14);
  EXPECT_EQ(distance(Point<3>(0., 0., 0.5), x, y),
            MidSurfaces::farthest * thickness);
}


TEST(MidSurfaces, CrossingsAreFoundToTheLastDigit)
{
  // a sheet that stands on another, and ends above or below it by 1e-15
  for (const double end : {1e-15, -1e-15})
    {
      std::vector<MidTriangle> triangles;
      add_square(triangles, Point<3>(), x, y, 1);
      add_square(triangles, Point<3>(0.3, 0.2, end), 0.2 * x, z, 1);
      EXPECT_EQ(state_of(triangles).n_crossing > 0, end < 0.);
    }
}


TEST(MidSurfaces, WhatHangsTogetherIsNotNear)
{
  // one part: its triangles are nearer than their thickness
  std::vector<MidTriangle> triangles;
  add_square(triangles, Point<3>(), x, y, 40);
  EXPECT_EQ(state_of(triangles).distance, MidSurfaces::farthest);

  // rolled up until its ends are one on the other, a twentieth of its length
  // apart, which is half a thickness: they are the same part but far apart when
  // flat
  const double   r = 1. / (2. * numbers::PI);
  Vector<double> u(3 * 41 * 41);
  for (const MidTriangle &t : triangles)
    for (unsigned int k = 0; k < 3; ++k)
      {
        const double phi = 0.95 * 2. * numbers::PI * t.x[k][0];
        u(t.dofs[k][0])  = r * std::sin(phi) - t.x[k][0];
        u(t.dofs[k][2])  = r * (1. - std::cos(phi));
      }
  const auto rolled = MidSurfaces(triangles, MPI_COMM_WORLD).state(u);
  EXPECT_NEAR(rolled.distance * thickness,
              2. * r * std::sin(0.05 * numbers::PI),
              1e-12);
}


TEST(MidSurfaces, SurfacesAroundShellsAreClosed)
{
  for (const std::string map : {"", "x; y; 0.2*x*y", "cos(x); sin(x); y"})
    for (const bool simplices : {false, true})
      {
        MeshParameters m;
        m.lower     = {0., 0.};
        m.upper     = {1., 1.};
        m.cells     = {5, 4};
        m.map       = map;
        m.simplices = simplices;
        Triangulation<2, 3> mesh;
        make_shell_mesh(m, mesh);
        ShellParameters p;
        p.section         = {1000., 0.3, thickness, 1.};
        p.contact_modulus = 1000.;
        const ShellBody shell("shell", mesh, p, {}, MPI_COMM_SELF);
        Vector<double>  u(shell.n_dofs());
        const double    offset  = 0.02;
        const auto      surface = shell.outer_surface(u, offset);

        // each edge once in each direction; volume by Gauss' theorem
        std::map<std::pair<std::string, std::string>, int> edges;
        double                                             volume = 0.;
        for (const auto &t : surface)
          {
            for (unsigned int k = 0; k < 3; ++k)
              {
                const auto name = [](const Point<3> &point) {
                  return num(point[0]) + num(point[1]) + num(point[2]);
                };
                ++edges[{name(t[k]), name(t[(k + 1) % 3])}];
                --edges[{name(t[(k + 1) % 3]), name(t[k])}];
              }
            volume += Tensor<1, 3>(t[0]) *
                      cross_product_3d(Tensor<1, 3>(t[1]), Tensor<1, 3>(t[2])) /
                      6.;
          }
        for (const auto &[edge, count] : edges)
          EXPECT_EQ(count, 0);
        // flat; the integral of sqrt(1 + 0.04 (x^2 + y^2)); five chords
        const double area = map.empty()   ? 1. :
                            map[0] == 'c' ? 10. * std::sin(0.1) :
                                            1.01321;
        if (map.empty())
          EXPECT_NEAR(volume, area * (thickness + 2. * offset), 1e-13);
        else // curvature changes it by the square of thickness over radius
          EXPECT_NEAR(volume, area * (thickness + 2. * offset), 5e-3 * volume);
      }
}


TEST(MidSurfaces, ForcesFromOutsideStretchABar)
{
  // a bar of 2 x 1 x 1, pulled at its end by 0.5 in all, small strains
  Log  log(MPI_COMM_WORLD, true);
  auto bar = make<3>(
    section("Bodies", "Names = bar") +
      section("Boundary conditions", "Names = end, y, z") +
      body(
        "bar",
        "Upper corner = 2,1,1|Cells = 4,2,2",
        "Law = linear elastic|Young's modulus = 1000|Poisson's ratio = 0.3") +
      condition("end", "Body = bar|Boundary ids = 0|x = 0") +
      condition("y", "Body = bar|Boundary ids = 2|y = 0") +
      condition("z", "Body = bar|Boundary ids = 4|z = 0") + solver(),
    log);
  const double force = 0.5;
  bar->model.outside_forces =
    [&](const Vector_t &, const double time, Vector_t &forces) {
      // a quarter of the force of a facet for each of its corners
      std::map<types::global_dof_index, double>   shares;
      std::map<types::global_dof_index, Point<3>> nodes;
      for (const auto &node : bar->model.bodies[0]->boundary_nodes({1}))
        nodes[node.dofs[0]] = node.x;
      for (const auto &[dof, at] : nodes)
        {
          double share = 0.25 * 0.25;
          for (unsigned int i = 1; i < 3; ++i)
            if (at[i] > 0.25 && at[i] < 0.75)
              share *= 2.;
          shares[dof] = share;
        }
      for (const auto &[dof, share] : shares)
        if (forces.in_local_range(dof))
          forces(dof) += time * force * share;
    };
  ASSERT_EQ(bar->run(), finished);
  // F L/(E A)
  const auto end = bar->model.bodies[0]->nearest_node({2., 0.5, 0.5});
  EXPECT_NEAR(bar->u(end.dofs[0]), force * 2. / 1000., 1e-12);
  EXPECT_NEAR(bar->model.reaction(0)[0], -force, 1e-12);
}
