// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/projection.h>
#include <mortar_contact/search/material_locator.h>

#include <algorithm>
#include <limits>

namespace MortarContact
{
  namespace
  {
    /// First reach of a search, in diameters of the largest facet; it grows by
    /// the factor up to one diameter.
    constexpr double first_reach = 1e-3, growth = 10.;

    template <int dim>
    std::vector<Box<dim>>
    boxes_of(const std::vector<Facet<dim>> &facets)
    {
      std::vector<Box<dim>> boxes;
      boxes.reserve(facets.size());
      for (const Facet<dim> &facet : facets)
        boxes.push_back(box_around(facet));
      return boxes;
    }

    template <int dim>
    std::vector<Box<dim>>
    boxes_of(const std::vector<Tensor<1, dim>> &points)
    {
      std::vector<Box<dim>> boxes;
      boxes.reserve(points.size());
      for (const Tensor<1, dim> &x : points)
        boxes.push_back({x, x});
      return boxes;
    }

    template <int dim>
    Box<dim>
    box_of(const Tensor<1, dim> &x, const double reach)
    {
      Box<dim> box = {x, x};
      inflate(box, reach);
      return box;
    }

    /// The point of a facet where the normal through @p x meets it, moved
    /// inside.
    template <int dim>
    PlanePoint<dim>
    nearest_on(const Facet<dim> &facet, const Tensor<1, dim> &x)
    {
      const Tensor<1, dim>                w      = centre_normal(facet);
      const Tensor<1, dim>                normal = w / w.norm();
      std::array<Tensor<1, dim>, dim - 1> basis;
      basis[0] = facet.x[1] - facet.x[0];
      basis[0] -= (basis[0] * normal) * normal;
      basis[0] /= basis[0].norm();
      if constexpr (dim == 3)
        basis[1] = cross_product_3d(normal, basis[0]);
      const auto in_plane = [&](const Tensor<1, dim> &p) {
        PlanePoint<dim> y;
        for (unsigned int c = 0; c < dim - 1; ++c)
          y[c] = basis[c] * (p - facet.x[0]);
        return y;
      };
      PlaneFacet<dim> vertices;
      for (unsigned int a = 0; a < facet.n_vertices; ++a)
        vertices[a] = in_plane(facet.x[a]);
      PlanePoint<dim> xi = reference_centre<dim>(facet.n_vertices);
      if (const auto found =
            inverse_map<dim>(facet.n_vertices, vertices, in_plane(x)))
        xi = *found;
      double sum = 0.;
      for (unsigned int c = 0; c < dim - 1; ++c)
        {
          xi[c] = std::min(1., std::max(0., xi[c]));
          sum += xi[c];
        }
      if (facet.n_vertices == 3 && sum > 1.)
        xi /= sum;
      return xi;
    }
  } // namespace


  template <int dim>
  MaterialLocator<dim>::MaterialLocator(std::vector<Facet<dim>>   facets,
                                        std::vector<unsigned int> parts)
    : facets(std::move(facets))
    , parts(std::move(parts))
    , broad_phase(boxes_of(this->facets))
  {
    for (const Facet<dim> &facet : this->facets)
      largest = std::max(largest, diameter(facet));
  }


  template <int dim>
  std::optional<unsigned int>
  MaterialLocator<dim>::same(const Facet<dim>  &facet,
                             const unsigned int part) const
  {
    // a vertex lies in its box to the last digit, a mean may not
    for (const unsigned int f : broad_phase.find(box_of(facet.x[0], 0.)))
      if (parts[f] == part && facets[f].n_vertices == facet.n_vertices &&
          std::equal(facet.x.begin(),
                     facet.x.begin() + facet.n_vertices,
                     facets[f].x.begin()))
        return f;
    return {};
  }


  template <int dim>
  std::optional<typename MaterialLocator<dim>::Place>
  MaterialLocator<dim>::find(const Tensor<1, dim> &x,
                             const Tensor<1, dim> &normal,
                             const unsigned int    part) const
  {
    std::optional<Place> best;
    double               least = std::numeric_limits<double>::max();
    // what is found within a box may be beaten by what lies beside it, but not
    // by what lies farther away than the box reaches
    for (double reach = first_reach * largest;
         reach < 1.01 * largest && least > reach;
         reach *= growth)
      for (const unsigned int f : broad_phase.find(box_of(x, reach)))
        {
          if (parts[f] != part || !(centre_normal(facets[f]) * normal > 0.))
            continue;
          const PlanePoint<dim> xi = nearest_on(facets[f], x);
          const double          distance =
            (interpolate(facets[f],
                         shape_values<dim>(facets[f].n_vertices, xi)) -
             x)
              .norm();
          if (distance < least)
            {
              least = distance;
              best  = Place{f, xi, distance};
            }
        }
    return best;
  }


  template <int dim>
  PointLocator<dim>::PointLocator(std::vector<Tensor<1, dim>> points)
    : points(std::move(points))
    , broad_phase(boxes_of(this->points))
  {}


  template <int dim>
  std::optional<unsigned int>
  PointLocator<dim>::find(const Tensor<1, dim> &x,
                          const double          first_reach) const
  {
    std::optional<unsigned int> best;
    double                      least = std::numeric_limits<double>::max();
    if (points.empty())
      return best;
    for (double reach = first_reach; least > reach; reach *= growth)
      for (const unsigned int i : broad_phase.find(box_of(x, reach)))
        {
          const double distance = (points[i] - x).norm();
          if (distance < least)
            {
              least = distance;
              best  = i;
            }
        }
    return best;
  }


  template class MaterialLocator<2>;
  template class MaterialLocator<3>;
  template class PointLocator<2>;
  template class PointLocator<3>;
} // namespace MortarContact
