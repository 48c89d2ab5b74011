// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_map_manifold_h
#define mortar_contact_applications_map_manifold_h

#include <deal.II/grid/manifold.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace Structure
{
  using namespace dealii;

  /**
   * New points between points of a mesh that was made by a map: the map of the
   * mean of their places before it. Knows its points by their coordinates;
   * those that it makes are added.
   */
  template <int dim>
  class MapManifold : public Manifold<dim>
  {
  public:
    explicit MapManifold(std::function<Point<dim>(const Point<dim> &)> map)
      : map(std::move(map))
      , before(std::make_shared<Places>())
    {}

    /// The point @p x came from @p place.
    void
    add(const Point<dim> &x, const Point<dim> &place) const
    {
      (*before)[key(x)] = place;
    }

    std::unique_ptr<Manifold<dim>>
    clone() const override
    {
      return std::make_unique<MapManifold<dim>>(*this);
    }

    Point<dim>
    get_new_point(const ArrayView<const Point<dim>> &points,
                  const ArrayView<const double>     &weights) const override
    {
      Point<dim> place, straight;
      bool       is_known = true;
      for (unsigned int i = 0; i < points.size(); ++i)
        {
          straight += weights[i] * points[i];
          const auto known = before->find(key(points[i]));
          if (known == before->end())
            is_known = false; // inside: nothing is known of it
          else
            place += weights[i] * known->second;
        }
      if (!is_known)
        return straight;
      const Point<dim> x = map(place);
      add(x, place);
      return x;
    }

  private:
    using Places = std::map<std::array<double, dim>, Point<dim>>;

    static std::array<double, dim>
    key(const Point<dim> &x)
    {
      std::array<double, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = x[i];
      return result;
    }

    std::function<Point<dim>(const Point<dim> &)> map;
    std::shared_ptr<Places>                       before; ///< Of all copies.
  };
} // namespace Structure

#endif
