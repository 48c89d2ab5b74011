// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_contact_resolution_h
#define mortar_contact_structure_contact_resolution_h

#include "mid_surfaces.h"
#include "model.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  /**
   * How well contact is resolved at the end of a step: what a program that is
   * to mesh the space between the bodies must know before it tries.
   */
  template <int dim>
  class ContactResolution
  {
  public:
    /// After the model is numbered.
    explicit ContactResolution(const Model<dim> &model);

    /// To be called for each Newton iterate, for `last_change`.
    void
    watch(const Model<dim> &model);

    /// Measure the state at @p u, which the interfaces have seen last.
    /// Collective.
    void
    measure(const Model<dim> &model, const Vector_t &u);

    /// Names and values for the history.
    std::vector<std::pair<std::string, double>>
    record() const;

    /// A line for the log, and a second one if something is wrong.
    std::vector<std::string>
    lines() const;

  private:
    /// Of one interface.
    struct Resolved
    {
      std::string name;
      /// Between facets that look at each other [m]; negative: penetration.
      double smallest_gap = 0., largest_gap = 0.;
      /// Largest difference of the penetrations of two facets with a common
      /// vertex, over their size [-].
      double gap_jump = 0.;
      /// Of the facets in contact along the last axis [m].
      double height = 0.;
      /// Of force and active area in the last Newton iteration, over them [-].
      double change = 0.;
    };
    std::vector<Resolved>        interfaces;
    std::unique_ptr<MidSurfaces> shells; ///< Null: there are none.
    MidSurfaces::State           shell_state;
    /// Force and active area of the interfaces in the last two iterates.
    std::vector<std::pair<Tensor<1, 3>, double>> before, last;
  };
} // namespace Structure

#endif
