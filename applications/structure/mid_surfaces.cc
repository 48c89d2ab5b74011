// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mid_surfaces.h"

#include <mortar_contact/search/broad_phase.h>

#include <deal.II/base/config.h>

DEAL_II_DISABLE_EXTRA_DIAGNOSTICS
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>
DEAL_II_ENABLE_EXTRA_DIAGNOSTICS

#include <algorithm>
#include <cmath>

namespace Structure
{
  namespace
  {
    using Kernel  = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Corners = std::array<Kernel::Point_3, 3>;

    Corners
    place(const MidTriangle &t, const Vector<double> *u)
    {
      Corners corners;
      for (unsigned int a = 0; a < 3; ++a)
        {
          Point<3> x = t.x[a];
          if (u != nullptr)
            for (unsigned int i = 0; i < 3; ++i)
              x[i] += (*u)(t.dofs[a][i]);
          corners[a] = Kernel::Point_3(x[0], x[1], x[2]);
        }
      return corners;
    }

    bool
    cross(const Corners &a, const Corners &b)
    {
      const Kernel::Triangle_3 s(a[0], a[1], a[2]), t(b[0], b[1], b[2]);
      return !s.is_degenerate() && !t.is_degenerate() &&
             CGAL::do_intersect(s, t);
    }

    /// Distance of two triangles that do not intersect: between two edges, or
    /// a vertex and the other's inside.
    double
    distance(const Corners &a, const Corners &b)
    {
      double nearest = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          nearest = std::min(
            nearest,
            CGAL::squared_distance(Kernel::Segment_3(a[i], a[(i + 1) % 3]),
                                   Kernel::Segment_3(b[j], b[(j + 1) % 3])));
      for (const auto &[x, y] :
           {std::make_pair(&a, &b), std::make_pair(&b, &a)})
        {
          const Kernel::Triangle_3 triangle((*y)[0], (*y)[1], (*y)[2]);
          if (!triangle.is_degenerate())
            for (const auto &corner : *x)
              nearest =
                std::min(nearest, CGAL::squared_distance(corner, triangle));
        }
      return std::sqrt(nearest);
    }

    MortarContact::Box<3>
    box_around(const Corners &corners)
    {
      MortarContact::Box<3> box;
      for (unsigned int i = 0; i < 3; ++i)
        {
          box.low[i]  = std::min({corners[0][i], corners[1][i], corners[2][i]});
          box.high[i] = std::max({corners[0][i], corners[1][i], corners[2][i]});
        }
      return box;
    }

    /// Call @p visit(i, j, corners of i, corners of j) for this rank's
    /// triangles i and all j > i whose boxes are nearer than @p reach.
    template <class Visitor>
    void
    for_each_near_pair(const std::vector<MidTriangle> &triangles,
                       const Vector<double>           *u,
                       const double                    reach,
                       const MPI_Comm                  communicator,
                       const Visitor                  &visit)
    {
      std::vector<Corners>               corners;
      std::vector<MortarContact::Box<3>> boxes;
      for (const MidTriangle &t : triangles)
        {
          corners.push_back(place(t, u));
          boxes.push_back(box_around(corners.back()));
        }
      const MortarContact::BroadPhase<3> broad_phase(boxes);
      const unsigned int                 n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int i = Utilities::MPI::this_mpi_process(communicator);
           i < triangles.size();
           i += n_ranks)
        {
          MortarContact::Box<3> around = boxes[i];
          MortarContact::inflate(around, reach);
          for (const unsigned int j : broad_phase.find(around))
            if (j > i)
              visit(i, j, corners[i], corners[j]);
        }
    }

    double
    mean_thickness(const MidTriangle &a, const MidTriangle &b)
    {
      return 0.5 * (a.thickness + b.thickness);
    }

    bool
    share_vertex(const MidTriangle &a, const MidTriangle &b)
    {
      for (const auto &v : a.dofs)
        for (const auto &w : b.dofs)
          if (v[0] == w[0])
            return true;
      return false;
    }
  } // namespace


  MidSurfaces::MidSurfaces(const std::vector<MidTriangle> &triangles,
                           const MPI_Comm                  communicator)
    : triangles(triangles)
    , communicator(communicator)
    , joined(triangles.size())
  {
    for (const MidTriangle &t : triangles)
      reach = std::max(reach, farthest * t.thickness);
    for_each_near_pair(triangles,
                       nullptr,
                       reach,
                       communicator,
                       [&](const unsigned int i,
                           const unsigned int j,
                           const Corners     &a,
                           const Corners     &b) {
                         const MidTriangle &s = triangles[i], &t = triangles[j];
                         if (share_vertex(s, t) ||
                             (s.part == t.part &&
                              distance(a, b) < farthest * mean_thickness(s, t)))
                           joined[i].push_back(j);
                       });
  }


  MidSurfaces::State
  MidSurfaces::state(const Vector<double> &u) const
  {
    State result;
    for_each_near_pair(
      triangles,
      &u,
      reach,
      communicator,
      [&](const unsigned int i,
          const unsigned int j,
          const Corners     &a,
          const Corners     &b) {
        if (std::binary_search(joined[i].begin(), joined[i].end(), j))
          return;
        if (cross(a, b))
          {
            ++result.n_crossing;
            result.distance = 0.;
          }
        else
          result.distance =
            std::min(result.distance,
                     distance(a, b) /
                       mean_thickness(triangles[i], triangles[j]));
      });
    result.distance   = Utilities::MPI::min(result.distance, communicator);
    result.n_crossing = Utilities::MPI::sum(result.n_crossing, communicator);
    return result;
  }
} // namespace Structure
