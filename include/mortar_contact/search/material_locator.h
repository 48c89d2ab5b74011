// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_search_material_locator_h
#define mortar_contact_search_material_locator_h

#include <mortar_contact/search/broad_phase.h>

#include <optional>
#include <vector>

namespace MortarContact
{
  /**
   * Finds the material points of a surface on another mesh of the same surface.
   * Both meshes are undeformed.
   */
  template <int dim>
  class MaterialLocator
  {
  public:
    /// A place on a surface.
    struct Place
    {
      /// Number in the list given.
      unsigned int    facet;
      PlanePoint<dim> xi;       ///< Inside.
      double          distance; ///< [m]
    };

    /// @param parts Of the facets.
    MaterialLocator(std::vector<Facet<dim>>   facets,
                    std::vector<unsigned int> parts);

    /// The facet with the same vertices in the same order.
    std::optional<unsigned int>
    same(const Facet<dim> &facet, const unsigned int part) const;

    /// The point nearest to @p x on the facets of a part that face like
    /// @p normal. Nothing: there are none within the diameter of
    /// the largest facet.
    std::optional<Place>
    find(const Tensor<1, dim> &x,
         const Tensor<1, dim> &normal,
         const unsigned int    part) const;

  private:
    std::vector<Facet<dim>>   facets;
    std::vector<unsigned int> parts;
    BroadPhase<dim>           broad_phase;
    double                    largest = 0.; ///< Diameter of a facet [m]
  };

  /// Finds the nearest of many points.
  template <int dim>
  class PointLocator
  {
  public:
    /// Over @p points [m].
    explicit PointLocator(std::vector<Tensor<1, dim>> points);

    /// Number of the point nearest to @p x; nothing: there are no points.
    /// @param first_reach Where to look first [m].
    std::optional<unsigned int>
    find(const Tensor<1, dim> &x, const double first_reach) const;

  private:
    std::vector<Tensor<1, dim>> points;
    BroadPhase<dim>             broad_phase;
  };
} // namespace MortarContact

#endif
