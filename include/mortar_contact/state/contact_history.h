// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_state_contact_history_h
#define mortar_contact_state_contact_history_h

#include <mortar_contact/geometry/facet.h>

#include <utility>
#include <vector>

namespace MortarContact
{
  /// Material points of a facet that carry state: 2 on lines, 3 on triangles,
  /// 2 x 2 on quadrilaterals (Gauss points; in the order of the vertices).
  template <int dim>
  std::vector<PlanePoint<dim>>
  material_points(const unsigned int n_vertices);

  /// Values at the vertices of the (bi)linear function that has the given
  /// values at the material points.
  template <int dim>
  VertexValues<dim>
  extrapolate_to_vertices(const unsigned int       n_vertices,
                          const VertexValues<dim> &at_points);

  /// The same for vectors in the facet's plane.
  template <int dim>
  std::array<PlanePoint<dim>, max_vertices<dim>>
  extrapolate_to_vertices(
    const unsigned int                                    n_vertices,
    const std::array<PlanePoint<dim>, max_vertices<dim>> &at_points);

  /**
   * State of the secondary facets of one sweep, those of this rank. What
   * carries force lives on material points, never on pairs, so nothing breaks
   * when a point meets another facet. Changes in commit() only. Allocated where
   * a scene needs it: an interface without initial penetrations, releases and
   * friction stores nothing.
   */
  template <int dim>
  struct ContactHistory
  {
    /// Level of the initial penetration at the material points, by facet;
    /// see offset() in laws/initial_penetration.h [m]. Empty: none.
    std::vector<VertexValues<dim>> level;

    /// Facets whose contact was released, until they open. Empty: none.
    std::vector<char> released;

    /// Pairs that have come to lie over each other without having been in front
    /// of each other, until they no longer do; sorted. The only state of pairs,
    /// and of their geometry alone. Empty: none.
    std::vector<std::pair<unsigned int, unsigned int>> aside;

    /// Elastic slip at the material points, components in the basis of the
    /// secondary frame, by facet [m]. Empty: no friction.
    std::vector<std::array<PlanePoint<dim>, max_vertices<dim>>> elastic_slip;

    /// Path length of sliding at the material points [m]. Empty: no friction.
    std::vector<VertexValues<dim>> sliding;

    /// Depth at the material points that augmentation adds [m]. Empty: none.
    std::vector<VertexValues<dim>> augmentation;

    /// Facets that ties hold: no contact until the last tie has failed. Empty:
    /// none.
    std::vector<char> tied;

    /// Positions of the facets of both sides at the end of the last accepted
    /// step. Empty: no friction.
    std::array<std::vector<Facet<dim>>, 2> before;

    /// What was left of the levels at the end of the last accepted step.
    double share = 0.;
  };
} // namespace MortarContact

#endif
