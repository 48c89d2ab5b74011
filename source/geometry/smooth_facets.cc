// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/smooth_facets.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/numerics/rtree.h>

#include <cmath>
#include <map>

namespace MortarContact
{
  namespace
  {
    /// Newton steps for a quadratic patch; about four are needed.
    constexpr unsigned int max_patch_steps = 20;

    /// Newton has converged when eta moves less: the next step would be of the
    /// size of its square.
    constexpr double patch_tolerance = 1e-9;

    /// Points may miss a patch by this, so that none falls between two.
    constexpr double between_patches = 1e-9;

    /// Patches bulge beyond their vertices by less than this share of their
    /// size for the creases that are smoothed.
    constexpr double bulge = 0.25;

    /// Normals closer than this to each other, as 1 - cos^2, give no bulge.
    constexpr double parallel_tangents = 1e-12;

    /// Nagata's curvature vector of the edge @p d between two normals.
    template <int dim>
    Tensor<1, dim>
    edge_curvature(const Tensor<1, dim> &d,
                   const Tensor<1, dim> &n0,
                   const Tensor<1, dim> &n1)
    {
      const double a   = n0 * n1;
      const double det = 1. - a * a;
      if (det < parallel_tangents)
        return Tensor<1, dim>();
      const double b0 = n0 * d, b1 = -(n1 * d);
      return ((b0 - a * b1) * n0 + (b1 - a * b0) * n1) / det;
    }
  } // namespace


  template <int dim>
  struct SmoothFacets<dim>::Tree
  {
    RTree<std::pair<BoundingBox<dim>, unsigned int>> tree;
  };


  template <int dim>
  SmoothFacets<dim>::SmoothFacets(const std::vector<Facet<dim>> &all,
                                  const double                   crease)
    : tree(std::make_unique<Tree>())
  {
    // Step 1: lines and triangles.
    std::vector<Facet<dim>> facets;
    if constexpr (dim == 2)
      facets = all;
    else
      for (const Facet<dim> &f : all)
        if (f.n_vertices == 4)
          for (const unsigned int v : {1u, 2u})
            {
              Facet<dim> half;
              half.n_vertices = 3;
              half.x[0]       = f.x[0];
              half.x[1]       = f.x[v];
              half.x[2]       = f.x[v + 1];
              facets.push_back(half);
            }
        else
          facets.push_back(f);

    // Step 2: normals at the vertices, means over the facets around (weighted
    // by area) that meet without a crease.
    const auto less = [](const Tensor<1, dim> &a, const Tensor<1, dim> &b) {
      for (unsigned int i = 0; i < dim; ++i)
        if (a[i] != b[i])
          return a[i] < b[i];
      return false;
    };
    std::map<Tensor<1, dim>, std::vector<unsigned int>, decltype(less)> around(
      less);
    std::vector<Tensor<1, dim>> normals;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        normals.push_back(centre_normal(facets[f]));
        for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
          around[facets[f].x[v]].push_back(f);
      }
    const auto normal_at = [&](const unsigned int f, const unsigned int v) {
      Tensor<1, dim> sum;
      for (const unsigned int g : around[facets[f].x[v]])
        if (normals[f] * normals[g] >
            std::cos(crease) * normals[f].norm() * normals[g].norm())
          sum += normals[g];
      return sum / sum.norm();
    };

    // Step 3: patches.
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    for (unsigned int f = 0; f < facets.size(); ++f)
      {
        const auto &x = facets[f].x;
        Patch       p;
        p.constant              = x[0];
        const Tensor<1, dim> n0 = normal_at(f, 0), n1 = normal_at(f, 1);
        const Tensor<1, dim> c1 =
          edge_curvature(Tensor<1, dim>(x[1] - x[0]), n0, n1);
        p.linear[0]    = x[1] - x[0] - c1;
        p.second[0][0] = 2. * c1;
        if constexpr (dim == 3)
          {
            // x = x0 + (d1 - c1) eta + (d2 - c2) zeta + c1 eta^2 + c2 zeta^2
            //     + (c1 + c2 - c3) eta zeta, edges 01, 02, 12: equal to each
            // edge's own quadratic
            const Tensor<1, dim> n2 = normal_at(f, 2);
            const Tensor<1, dim> c2 =
              edge_curvature(Tensor<1, dim>(x[2] - x[0]), n0, n2);
            const Tensor<1, dim> c3 =
              edge_curvature(Tensor<1, dim>(x[2] - x[1]), n1, n2);
            p.linear[1]    = x[2] - x[0] - c2;
            p.second[1][1] = 2. * c2;
            p.second[0][1] = p.second[1][0] = c1 + c2 - c3;
          }
        Point<dim> low(x[0]), high(x[0]);
        for (unsigned int v = 0; v < facets[f].n_vertices; ++v)
          for (unsigned int i = 0; i < dim; ++i)
            {
              low[i]  = std::min(low[i], x[v][i]);
              high[i] = std::max(high[i], x[v][i]);
            }
        const double by = bulge * diameter(facets[f]);
        for (unsigned int i = 0; i < dim; ++i)
          {
            low[i] -= by;
            high[i] += by;
          }
        boxes.emplace_back(BoundingBox<dim>({low, high}), patches.size());
        patches.push_back(p);
      }
    tree->tree = pack_rtree(boxes);
  }


  template <int dim>
  SmoothFacets<dim>::~SmoothFacets() = default;


  template <int dim>
  bool
  SmoothFacets<dim>::is_far_in_body(const Tensor<1, dim> &X,
                                    const double          r) const
  {
    Point<dim> low(X), high(X);
    for (unsigned int i = 0; i < dim; ++i)
      {
        low[i] -= r;
        high[i] += r;
      }
    namespace bgi = boost::geometry::index;
    const BoundingBox<dim> box({low, high});
    return tree->tree.qbegin(bgi::intersects(box)) == tree->tree.qend();
  }


  template <int dim>
  std::optional<SurfacePoint<dim>>
  SmoothFacets<dim>::meet_in_body(const Tensor<1, dim> &X,
                                  const Tensor<1, dim> &N,
                                  const double          range) const
  {
    constexpr unsigned int T = dim - 1;
    Point<dim>             low, high;
    for (unsigned int i = 0; i < dim; ++i)
      {
        low[i]  = X[i] - range * std::abs(N[i]);
        high[i] = X[i] + range * std::abs(N[i]);
      }
    namespace bgi = boost::geometry::index;
    std::optional<SurfacePoint<dim>> nearest;
    double                           nearest_depth = range;
    const BoundingBox<dim>           box({low, high});
    for (auto it = tree->tree.qbegin(bgi::intersects(box));
         it != tree->tree.qend();
         ++it)
      {
        // x(eta) + d N = X
        const Patch    &p = patches[it->second];
        PlanePoint<dim> eta;
        for (unsigned int b = 0; b < T; ++b)
          eta[b] = 1. / dim;
        SurfacePoint<dim> at;
        double            d         = 0.;
        bool              converged = false;
        for (unsigned int step = 0; step < max_patch_steps; ++step)
          {
            at.x = p.constant;
            for (unsigned int b = 0; b < T; ++b)
              {
                at.tangents[b] = p.linear[b];
                for (unsigned int c = 0; c < T; ++c)
                  at.tangents[b] += eta[c] * p.second[b][c];
                at.x += 0.5 * eta[b] * (p.linear[b] + at.tangents[b]);
              }
            if (converged)
              break;
            Tensor<2, dim> J;
            for (unsigned int i = 0; i < dim; ++i)
              {
                for (unsigned int b = 0; b < T; ++b)
                  J[i][b] = at.tangents[b][i];
                J[i][T] = N[i];
              }
            if (!(std::abs(determinant(J)) > 0.))
              break;
            const Tensor<1, dim> move =
              invert(J) * Tensor<1, dim>(X - at.x - d * N);
            double size = 0.;
            for (unsigned int b = 0; b < T; ++b)
              {
                eta[b] += move[b];
                size = std::max(size, std::abs(move[b]));
              }
            d += move[T];
            converged = size < patch_tolerance;
            if (!(eta.norm() < 10.))
              break;
          }
        if (!converged ||
            !is_inside<dim>(dim == 2 ? 2 : 3, eta, between_patches) ||
            !(std::abs(d) <= nearest_depth))
          continue;
        Tensor<1, dim> m;
        if constexpr (dim == 2)
          m = cross_product_2d(at.tangents[0]);
        else
          m = cross_product_3d(at.tangents[0], at.tangents[1]);
        if (!(m * N < 0.))
          continue;
        at.second     = p.second;
        nearest       = at;
        nearest_depth = std::abs(d);
      }
    return nearest;
  }


  template class SmoothFacets<2>;
  template class SmoothFacets<3>;
} // namespace MortarContact
