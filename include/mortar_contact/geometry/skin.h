// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_skin_h
#define mortar_contact_geometry_skin_h

#include <mortar_contact/geometry/facet.h>

#include <vector>

namespace MortarContact
{
  /// A facet with all that the kernel wants to know of it.
  template <int dim>
  struct ContactFacet
  {
    Facet<dim> current;   ///< Present positions [m].
    Facet<dim> reference; ///< Undeformed positions [m].
    /// l/K at the vertices [m/Pa]; zero for a rigid side.
    VertexValues<dim> compliance = {};
    /// Characteristic length l at the vertices [m].
    VertexValues<dim> length = {};
    /// Contact surface minus mesh surface along the outward normal [m].
    double surface_offset = 0.;
  };

  /// Of all facets of a surface, those of other ranks too.
  struct SkinSizes
  {
    double mean_diameter      = 0.; ///< Of the facets, undeformed [m].
    double largest_length     = 0.; ///< Largest l at a vertex [m].
    double largest_compliance = 0.; ///< Largest l/K at a vertex [m/Pa].
    double largest_offset     = 0.; ///< Largest size of surface_offset [m].
  };

  /**
   * What a body shows to contact: one-sided facets with their vertices. Plain
   * data; where the facets come from is the host's business.
   */
  template <int dim>
  struct Skin
  {
    /// Those of this rank, over which it integrates where the skin is
    /// secondary; then those of other ranks that have come near. More may come
    /// at the end, none goes.
    std::vector<ContactFacet<dim>> facets;

    /// How many of them are of this rank.
    unsigned int n_own = 0;

    /// Numbers of the facets' vertices; vertices that two facets share have
    /// the same number, also across skins of one interface.
    std::vector<std::array<unsigned int, max_vertices<dim>>> vertices;

    /// Numbers of the parts that the facets belong to.
    std::vector<unsigned int> parts;

    SkinSizes sizes; ///< Of the whole surface.
  };

  /// Where the facets of a skin are.
  template <int dim>
  inline std::vector<Facet<dim>>
  current_facets(const Skin<dim> &skin)
  {
    std::vector<Facet<dim>> result;
    result.reserve(skin.facets.size());
    for (const ContactFacet<dim> &facet : skin.facets)
      result.push_back(facet.current);
    return result;
  }
} // namespace MortarContact

#endif
