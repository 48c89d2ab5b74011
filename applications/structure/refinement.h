// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_refinement_h
#define mortar_contact_structure_refinement_h

#include "model.h"

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Structure
{
  /// When meshes are refined, and how far.
  struct RefinementParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    bool
    is_on() const
    {
      return every > 0 || !times.empty();
    }

    /// Whether the step number @p step that ended at @p time is one to refine.
    bool
    is_due(const unsigned int step,
           const double       time,
           const double       same_time) const;

    unsigned int             every = 0; ///< Steps; 0: never.
    std::vector<double>      times;
    unsigned int             cycles       = 1;
    double                   refine_share = 0.5, coarsen_share = 0.;
    unsigned int             most_levels = 3;
    double                   most_cells  = 0.;
    std::vector<std::string> bodies; ///< Empty: all that can be.
  };

  /**
   * Squared error indicators of the cells [J], of all ranks, by body (empty: it
   * cannot be refined) and active cell: those of the body, mu h/24 times the
   * squared jumps of the displacement gradient (Kelly et al.,
   * doi:10.1002/nme.1620191103), and for the contact facets of a cell h A
   * (p_max - p_min)^2 / (24 K), p the pressures at the vertices, A the facet's
   * area, h its diameter, K its contact modulus: the same, for the pressure
   * that the facet cannot follow. It is largest where contact begins.
   */
  template <int dim>
  std::vector<std::vector<double>>
  error_indicators(const Model<dim> &model, const Vector_t &u);

  /**
   * Flags for Body::refine() of the bodies of a model. The cells with the
   * largest indicators that hold @p refine_share of the sum of all bodies are
   * refined (W. Doerfler, doi:10.1137/0733054), those with the smallest that
   * hold @p coarsen_share are coarsened. Empty: there is nothing to refine.
   */
  template <int dim>
  std::vector<std::string>
  mark_cells(const Model<dim>           &model,
             const Vector_t             &u,
             const RefinementParameters &parameters);
} // namespace Structure

#endif
