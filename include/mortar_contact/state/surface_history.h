// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_state_surface_history_h
#define mortar_contact_state_surface_history_h

#include <mortar_contact/geometry/facet.h>
#include <mortar_contact/laws/tie_law.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <utility>
#include <vector>

namespace MortarContact
{
  /// What one facet remembers, see ContactHistory, and where it is: numbers of
  /// facets mean nothing on another mesh.
  template <int dim>
  struct FacetHistory
  {
    Facet<dim>        undeformed;           ///< The facet [m].
    unsigned int      part         = 0;     ///< Of the surface.
    bool              is_released  = false; ///< See ContactHistory.
    VertexValues<dim> level        = {};    ///< At the material points [m].
    VertexValues<dim> sliding      = {};    ///< At the material points [m].
    VertexValues<dim> augmentation = {};    ///< At the material points [m].
    /// Components in the basis of the facet at the end of the last accepted
    /// step [m], and
    std::array<PlanePoint<dim>, max_vertices<dim>> elastic_slip;
    /// the facet there; both with friction only.
    Facet<dim> accepted;

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &undeformed &part &is_released &level &sliding &augmentation
        &elastic_slip &accepted;
    }
  };

  /**
   * State of one sweep on all ranks, free of their number and of the mesh: it
   * can be continued on any other mesh of the same surfaces.
   */
  template <int dim>
  struct SurfaceHistory
  {
    /// Secondary facets; empty if no facet remembers anything.
    std::vector<FacetHistory<dim>> facets;
    bool has_levels       = false; ///< Which parts of facets count: level,
    bool has_releases     = false; ///< is_released,
    bool has_slip         = false; ///< sliding, elastic_slip and accepted,
    bool has_augmentation = false; ///< augmentation.

    /// Pairs that are set aside, see ContactHistory: the two facets,
    /// undeformed, and their parts.
    struct PairAside
    {
      std::array<Facet<dim>, 2>   undeformed; ///< The facets [m].
      std::array<unsigned int, 2> parts;      ///< Of the surface.

      /// For checkpoints and between ranks.
      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &undeformed &parts;
      }
    };
    std::vector<PairAside> aside; ///< Pairs that are set aside.

    /// What was left of the levels at the end of the last accepted step.
    double share = 0.;

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &facets &has_levels &has_releases &has_slip &has_augmentation
        &aside &share;
    }
  };

  /// State of the ties of an interface on all ranks.
  template <int dim>
  struct TiesHistory
  {
    /// Undeformed place on the secondary, and what the tie there remembers.
    std::vector<std::pair<Tensor<1, dim>, TieHistory>> ties;
    double                                             dissipated = 0.; ///< [J]

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &ties &dissipated;
    }
  };
} // namespace MortarContact

#endif
