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

  /**
   * What a body shows to contact: one-sided facets with their vertices. Plain
   * data; where the facets come from is the host's business.
   */
  template <int dim>
  struct Skin
  {
    /// All of the surface, in the order of its numbers.
    std::vector<ContactFacet<dim>> facets;

    /// Numbers of the facets' vertices; vertices that two facets share have
    /// the same number, also across skins of one interface.
    std::vector<std::array<unsigned int, max_vertices<dim>>> vertices;

    /// Numbers of the parts that the facets belong to.
    std::vector<unsigned int> parts;

    /// Whether this rank integrates over the facet where the skin is secondary.
    std::vector<char> is_owned;
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
