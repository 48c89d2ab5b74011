// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_directors.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <sstream>
#include <string>

namespace Structure
{
  namespace
  {
    /// Normals that differ more make a kink: 20 degrees, as a cosine.
    constexpr double kink = 0.93969262078590838;

    /// Of directors at kinks: 120 degrees.
    constexpr double longest = 2.;

    std::string
    place(const Point<3> &x)
    {
      std::ostringstream text;
      text.precision(4);
      text << "(" << x << ")";
      return text.str();
    }
  } // namespace


  std::vector<unsigned int>
  cyclic_vertices(const Triangulation<2, 3>::cell_iterator &cell)
  {
    std::vector<unsigned int> v;
    for (const unsigned int k : cell->vertex_indices())
      v.push_back(cell->vertex_index(k));
    if (v.size() == 4)
      std::swap(v[2], v[3]);
    return v;
  }


  std::vector<int>
  orient(const Triangulation<2, 3> &mesh)
  {
    // Of the coarsest cells, which have no hanging nodes: their children run
    // as they do. Cells of each edge, and whether they run from its lower to
    // its higher vertex:
    using Edge = std::pair<unsigned int, unsigned int>;
    struct Side
    {
      unsigned int cell;
      bool         upwards;
    };
    const unsigned int                n_cells = mesh.n_cells(0);
    std::map<Edge, std::vector<Side>> sides;
    std::vector<std::vector<Edge>>    edges(n_cells);
    std::vector<Tensor<1, 3>>         normals(n_cells);
    const std::vector<Point<3>>      &x = mesh.get_vertices();
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      {
        const unsigned int c = cell->index();
        const auto         v = cyclic_vertices(cell);
        Tensor<1, 3>      &n = normals[c];
        n = cross_product_3d(x[v[2]] - x[v[0]], x[v.back()] - x[v[1]]);
        n /= std::max(n.norm(), std::numeric_limits<double>::min());
        for (unsigned int k = 0; k < v.size(); ++k)
          {
            const unsigned int a = v[k], b = v[(k + 1) % v.size()];
            const Edge         edge(std::min(a, b), std::max(a, b));
            sides[edge].push_back({c, a < b});
            edges[c].push_back(edge);
          }
      }

    std::vector<int> sign(n_cells, 0);
    for (unsigned int first = 0; first < sign.size(); ++first)
      {
        if (sign[first] != 0)
          continue;
        sign[first] = 1;
        std::queue<unsigned int> next({first});
        while (!next.empty())
          {
            const unsigned int c = next.front();
            next.pop();
            for (const Edge &edge : edges[c])
              {
                // at junctions the sheet goes on where it bends least
                const auto  &of_edge = sides.at(edge);
                unsigned int here = 0, there = 0;
                double       best = (of_edge.size() == 2) ? -1. : kink;
                for (unsigned int k = 0; k < of_edge.size(); ++k)
                  if (of_edge[k].cell == c)
                    here = there = k;
                for (unsigned int k = 0; k < of_edge.size(); ++k)
                  if (k != here &&
                      std::abs(normals[c] * normals[of_edge[k].cell]) > best)
                    {
                      best  = std::abs(normals[c] * normals[of_edge[k].cell]);
                      there = k;
                    }
                if (there == here)
                  continue;
                const unsigned int other = of_edge[there].cell;
                // neighbours that agree run along their edge in opposite ways
                const int expected =
                  (of_edge[here].upwards != of_edge[there].upwards) ? sign[c] :
                                                                      -sign[c];
                if (sign[other] == 0)
                  {
                    sign[other] = expected;
                    next.push(other);
                  }
                AssertThrow(sign[other] == expected,
                            ExcMessage("The shell is one-sided (a Moebius "
                                       "strip): it has no top and bottom."));
              }
          }
      }

    std::vector<int> result(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      {
        Triangulation<2, 3>::cell_iterator ancestor = cell;
        while (ancestor->level() > 0)
          ancestor = ancestor->parent();
        result[cell->active_cell_index()] = sign[ancestor->index()];
      }
    return result;
  }


  std::vector<Tensor<1, 3>>
  directors_of(const Triangulation<2, 3>        &mesh,
               const std::vector<int>           &orientation,
               const std::vector<SymmetryPlane> &planes)
  {
    struct Normal
    {
      Tensor<1, 3> n;
      double       angle;
    };
    std::vector<std::vector<Normal>>       normals(mesh.n_vertices());
    std::vector<std::vector<Tensor<1, 3>>> in_plane(mesh.n_vertices());
    const std::vector<Point<3>>           &x = mesh.get_vertices();
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const auto         v = cyclic_vertices(cell);
        const unsigned int m = v.size();
        for (unsigned int k = 0; k < m; ++k)
          {
            const Tensor<1, 3> a = x[v[(k + 1) % m]] - x[v[k]];
            const Tensor<1, 3> b = x[v[(k + m - 1) % m]] - x[v[k]];
            const Tensor<1, 3> w = cross_product_3d(a, b);
            AssertThrow(w.norm() > 1e-12 * a.norm() * b.norm(),
                        ExcMessage("A shell element has a corner of 0 or 180 "
                                   "degrees at " +
                                   place(x[v[k]]) + "."));
            normals[v[k]].push_back(
              {orientation[cell->active_cell_index()] * w / w.norm(),
               std::atan2(w.norm(), a * b)});
          }
        for (const unsigned int f : cell->face_indices())
          for (const SymmetryPlane &plane : planes)
            if (cell->face(f)->at_boundary() &&
                plane.first.count(cell->face(f)->boundary_id()) > 0)
              {
                const Tensor<1, 3> along =
                  cell->face(f)->vertex(1) - cell->face(f)->vertex(0);
                AssertThrow(std::abs(along * plane.second) <
                              1e-3 * along.norm(),
                            ExcMessage("The edge at " +
                                       place(cell->face(f)->center()) +
                                       " does not lie in its plane of "
                                       "symmetry. Check 'Plane normal'."));
                for (const unsigned int k : cell->face(f)->vertex_indices())
                  in_plane[cell->face(f)->vertex_index(k)].push_back(
                    plane.second);
              }
      }

    std::vector<Tensor<1, 3>> directors(mesh.n_vertices());
    for (unsigned int i = 0; i < directors.size(); ++i)
      {
        if (normals[i].empty())
          continue;
        Tensor<1, 3> &d = directors[i];
        for (const Normal &normal : normals[i])
          d += normal.angle * normal.n;
        bool is_smooth = d.norm() > 0.;
        for (const Normal &normal : normals[i])
          for (const Normal &other : normals[i])
            is_smooth = is_smooth && normal.n * other.n > kink;
        if (!is_smooth)
          {
            // least squares, with a little weight that keeps it short
            Tensor<2, 3> A;
            Tensor<1, 3> right;
            for (unsigned int c = 0; c < 3; ++c)
              A[c][c] = 1e-6;
            for (const Normal &normal : normals[i])
              {
                A += outer_product(normal.n, normal.n);
                right += normal.n;
              }
            d = invert(A) * right;
            for (const Normal &normal : normals[i])
              AssertThrow(d * normal.n > 0.2,
                          ExcMessage("Sheets of a shell are folded onto each "
                                     "other at " +
                                     place(x[i]) +
                                     ": no director points out of all of "
                                     "them."));
            AssertThrow(d.norm() < longest,
                        ExcMessage("A shell has a sharp fold at " +
                                   place(x[i]) +
                                   "; expected less than 120 degrees. Round "
                                   "it, or join two shells by a tie."));
          }
        else
          d /= d.norm();
        // the planes, made perpendicular to each other
        const double              length = d.norm();
        std::vector<Tensor<1, 3>> axes;
        for (Tensor<1, 3> m : in_plane[i])
          {
            for (const Tensor<1, 3> &a : axes)
              m -= (m * a) * a;
            if (m.norm() < 1e-6)
              continue;
            axes.push_back(m / m.norm());
            d -= (d * axes.back()) * axes.back();
          }
        AssertThrow(d.norm() > 0.5 * length,
                    ExcMessage("A shell is tangential to its plane of symmetry "
                               "at " +
                               place(x[i]) +
                               "; expected one that crosses it. Check 'Plane "
                               "normal'."));
        d *= length / d.norm();
      }

    // a hanging node is in the middle of an edge, its director too
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->has_children())
          directors[face->child(0)->vertex_index(1)] =
            0.5 * (directors[face->vertex_index(0)] +
                   directors[face->vertex_index(1)]);
    return directors;
  }
} // namespace Structure
