// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>
#include <utility>

namespace Structure
{
  void
  thicken(const double                            thickness,
          std::vector<Tensor<1, 3>>              &vertices,
          std::vector<std::vector<unsigned int>> &facets)
  {
    // Step 1: where each vertex goes, so that the facets around it move by half
    // the thickness in the mean; and the edges, as they run.
    const unsigned int                     n = vertices.size();
    std::vector<Tensor<1, 3>>              normals(facets.size()), d(n);
    std::vector<std::vector<unsigned int>> around(n);
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> edges;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const std::vector<unsigned int> &v = facets[f];
        normals[f] = cross_product_3d(vertices[v[2]] - vertices[v[0]],
                                      vertices[v.back()] - vertices[v[1]]);
        normals[f] /= normals[f].norm();
        for (unsigned int k = 0; k < v.size(); ++k)
          {
            d[v[k]] += normals[f];
            around[v[k]].push_back(f);
            const auto edge = std::make_pair(v[k], v[(k + 1) % v.size()]);
            AssertThrow(++edges[edge] == 1,
                        ExcMessage("'Thickness' is set, but the facets of the "
                                   "sheet do not run alike around its "
                                   "normal."));
          }
      }
    for (unsigned int i = 0; i < n; ++i)
      if (!around[i].empty())
        {
          double along = 0.;
          for (const unsigned int f : around[i])
            along += d[i] * normals[f] / around[i].size();
          AssertThrow(along > 0.1 * d[i].norm(),
                      ExcMessage("'Thickness' is set, but the sheet is folded "
                                 "onto itself."));
          d[i] /= along;
        }

    // Step 2: top, bottom, edges.
    std::vector<Tensor<1, 3>>              x;
    std::vector<std::vector<unsigned int>> all = facets;
    for (const double side : {0.5, -0.5})
      for (unsigned int i = 0; i < n; ++i)
        x.push_back(vertices[i] + side * thickness * d[i]);
    for (std::vector<unsigned int> below : facets)
      {
        std::reverse(below.begin(), below.end());
        for (unsigned int &v : below)
          v += n;
        all.push_back(below);
      }
    for (const auto &edge : edges)
      {
        const auto [a, b] = edge.first;
        if (edges.count({b, a}) == 0)
          all.push_back({b, a, a + n, b + n});
      }
    vertices = x;
    facets   = all;
  }
} // namespace Structure
