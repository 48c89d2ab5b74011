// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ellipsoid.h"

#include <deal.II/base/numbers.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Structure
{
  namespace
  {
    using Directions = std::vector<Tensor<1, 3>>;
    using Facets     = std::vector<std::vector<unsigned int>>;

    /// Quadrilaterals on the unit sphere: a cube's faces of n x n cells at
    /// equal angles; n is even, so that cells end at the planes of symmetry.
    void
    cubed_sphere(const unsigned int n, Directions &directions, Facets &facets)
    {
      using Key = std::array<int, 3>;
      std::map<Key, unsigned int> known;
      const auto                  vertex = [&](const Key &key) {
        const auto inserted = known.try_emplace(key, directions.size());
        if (inserted.second)
          {
            Tensor<1, 3> d;
            for (unsigned int i = 0; i < 3; ++i)
              d[i] = std::tan(0.25 * numbers::PI * (2. * key[i] / n - 1.));
            directions.push_back(d / d.norm());
          }
        return inserted.first->second;
      };
      for (unsigned int axis = 0; axis < 3; ++axis)
        for (const bool is_high : {false, true})
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              {
                const auto corner = [&](const unsigned int a,
                                        const unsigned int b) {
                  Key key;
                  key[axis]           = is_high ? n : 0;
                  key[(axis + 1) % 3] = a;
                  key[(axis + 2) % 3] = b;
                  return vertex(key);
                };
                std::vector<unsigned int> facet = {corner(i, j),
                                                   corner(i + 1, j),
                                                   corner(i + 1, j + 1),
                                                   corner(i, j + 1)};
                if (!is_high)
                  std::reverse(facet.begin(), facet.end());
                facets.push_back(facet);
              }
    }

    unsigned int
    cells_for(const Tensor<1, 3> &axes, const double size)
    {
      const double longest = std::max({axes[0], axes[1], axes[2]});
      const double n       = 0.5 * numbers::PI * longest / size;
      return 2 * static_cast<unsigned int>(std::max(1., std::ceil(0.5 * n)));
    }

    Tensor<1, 3>
    stretched(const Tensor<1, 3> &direction, const Tensor<1, 3> &axes)
    {
      Tensor<1, 3> x;
      for (unsigned int i = 0; i < 3; ++i)
        x[i] = axes[i] * direction[i];
      return x;
    }
  } // namespace


  double
  Ellipsoid::level(const Tensor<1, 3> &x) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double s = (x[i] - centre[i]) / axes[i];
        sum += s * s;
      }
    return std::sqrt(sum);
  }


  void
  make_surface(const std::vector<Ellipsoid>           &ellipsoids,
               const double                            size,
               std::vector<Tensor<1, 3>>              &vertices,
               std::vector<std::vector<unsigned int>> &facets)
  {
    vertices.clear();
    facets.clear();
    for (const Ellipsoid &e : ellipsoids)
      {
        Directions directions;
        Facets     quads;
        cubed_sphere(cells_for(e.axes, size), directions, quads);
        const unsigned int first = vertices.size();
        for (const Tensor<1, 3> &d : directions)
          vertices.push_back(e.centre + stretched(d, e.axes));
        const auto is_buried = [&](const std::vector<unsigned int> &quad) {
          return std::any_of(
            ellipsoids.begin(), ellipsoids.end(), [&](const Ellipsoid &other) {
              return &other != &e &&
                     std::all_of(quad.begin(), quad.end(), [&](const auto v) {
                       return other.level(vertices[first + v]) < 1.;
                     });
            });
        };
        for (std::vector<unsigned int> &quad : quads)
          {
            if (is_buried(quad))
              continue;
            for (unsigned int &v : quad)
              v += first;
            facets.push_back(quad);
          }
      }
  }


  void
  make_lower_layer(const Ellipsoid   &e,
                   const double       thickness,
                   const unsigned int n_layers,
                   const double       size,
                   Triangulation<3>  &mesh)
  {
    Directions directions;
    Facets     quads;
    cubed_sphere(cells_for(e.axes, size), directions, quads);

    std::vector<Point<3>>    vertices;
    std::vector<CellData<3>> cells;
    const unsigned int       n = directions.size();
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      for (const Tensor<1, 3> &d : directions)
        {
          Tensor<1, 3> axes = e.axes;
          for (unsigned int i = 0; i < 3; ++i)
            axes[i] -= thickness * (n_layers - layer) / n_layers;
          vertices.emplace_back(Point<3>(e.centre + stretched(d, axes)));
        }
    for (const std::vector<unsigned int> &quad : quads)
      {
        double z = 0.;
        for (const unsigned int v : quad)
          z += directions[v][2];
        if (z >= 0.)
          continue;
        for (unsigned int layer = 0; layer < n_layers; ++layer)
          {
            CellData<3> cell;
            // deal.II's order: 0 1 3 2 is counterclockwise
            const unsigned int order[4] = {0, 1, 3, 2};
            for (unsigned int v = 0; v < 4; ++v)
              {
                cell.vertices[v]     = layer * n + quad[order[v]];
                cell.vertices[4 + v] = (layer + 1) * n + quad[order[v]];
              }
            cells.push_back(cell);
          }
      }
    SubCellData none;
    GridTools::delete_unused_vertices(vertices, cells, none);
    mesh.create_triangulation(vertices, cells, none);
    const auto on = [&](const Point<3> &x, const double inset) {
      Ellipsoid shrunk = e;
      for (unsigned int i = 0; i < 3; ++i)
        shrunk.axes[i] -= inset;
      return std::abs(shrunk.level(x) - 1.) < 1e-9;
    };
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            bool inside = true, outside = true;
            for (const unsigned int v : face->vertex_indices())
              {
                inside  = inside && on(face->vertex(v), thickness);
                outside = outside && on(face->vertex(v), 0.);
              }
            face->set_boundary_id(inside ? 1 : outside ? 3 : 0);
          }
  }
} // namespace Structure
