// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_report_contact_report_h
#define mortar_contact_report_contact_report_h

#include <mortar_contact/laws/initial_penetration.h>

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <limits>
#include <string>
#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /// A facet in words a user can find it by.
  struct FacetLabel
  {
    std::string             part; ///< Name given with add_secondary/primary.
    types::global_dof_index cell = 0; ///< Global active cell index of the part.

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &part &cell;
    }
  };

  /// One of the deepest penetrations.
  struct DeepPenetration
  {
    double       penetration = 0.; ///< [m]
    double       relative    = 0.; ///< Over the release depth; 1: released.
    FacetLabel   secondary;        ///< Facet,
    FacetLabel   primary;          ///< and what it is in.
    Tensor<1, 3> position;         ///< [m]

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &penetration &relative &secondary &primary &position;
    }
  };

  /// What was found at the start, and what is done about it.
  struct InitialReport
  {
    unsigned int    n_facets = 0; ///< Facets that penetrate and are treated.
    DeepPenetration deepest;      ///< Of them.
    /// IGNORE
    InitialPenetration treatment      = InitialPenetration::stress;
    double             asked_pressure = 0.; ///< That should remain [Pa].
    /// Facets that penetrate by more than the release depth: no contact there
    /// until they separate (IGNORE 0 to 3).
    unsigned int    n_undetected = 0;
    DeepPenetration undetected; ///< The deepest of them.
    /// Ranges of contact modulus [Pa] and characteristic length [m], one per
    /// side: secondary, primary.
    double lowest_modulus[2]  = {0., 0.};
    double highest_modulus[2] = {0., 0.}; ///< See lowest_modulus.
    double lowest_length[2]   = {0., 0.}; ///< See lowest_modulus.
    double highest_length[2]  = {0., 0.}; ///< See lowest_modulus.
    /// Facets of the sides.
    unsigned int n_side_facets[2] = {0, 0};
    /// Tool facets that were turned over to point to the blank.
    unsigned int n_turned = 0;
    /// Rigid facets of open surfaces that point away from the other side, in
    /// automatic contact: it passes them unseen.
    unsigned int n_facing_away    = 0;
    double       secondary_area   = 0.; ///< With ties only [m^2],
    double       tied_area        = 0.; ///< and what of it is tied [m^2].
    double       largest_tied_gap = 0.; ///< [m]
    double       loose_area       = 0.; ///< Of facets that are tied in part.
    unsigned int n_free_facets    = 0;  ///< Secondary facets without a tie.
  };

  /**
   * State of one interface, summed over all ranks. Forces act on the secondary
   * body; those of a single surface on its first part (nothing, where it meets
   * itself only). Two-sided interfaces count pairs of both sweeps, and areas
   * once.
   */
  struct ContactReport
  {
    std::string   name;    ///< Of the interface.
    InitialReport initial; ///< Of setup().

    /// Pairs that the search has found.
    unsigned int candidate_pairs  = 0;
    unsigned int active_pairs     = 0; ///< With a penetration.
    unsigned int open_pairs       = 0; ///< Overlap, but a gap.
    unsigned int apart_pairs      = 0; ///< No overlap.
    unsigned int beyond_pairs     = 0; ///< Points behind the other surface.
    unsigned int degenerate_pairs = 0; ///< Facets without a usable shape.
    /// Pairs with an overlap, which is the work, of the rank that has most.
    unsigned int busiest_rank_pairs = 0;

    double active_area          = 0.; ///< Undeformed [m^2]
    double slip_area            = 0.; ///< Of it, sliding [m^2]
    double dissipation          = 0.; ///< By friction, since setup() [J]
    double elastic_slip         = 0.; ///< Largest of present points [m]
    double whole_tied_area      = 0.; ///< Ties without damage [m^2]
    double failed_tied_area     = 0.; ///< Ties that failed [m^2]
    double damage_dissipation   = 0.; ///< By ties, since setup() [J]
    double largest_tie_jump     = 0.; ///< Of ties that hold [m]
    double energy               = 0.; ///< In the contact springs [J]
    double largest_penetration  = 0.; ///< [m]
    double largest_pressure     = 0.; ///< Per undeformed area [Pa]
    double relative_penetration = 0.; ///< Largest, over the release depth.
    double mean_penetration     = 0.; ///< Over the active area [m]
    double largest_overlap      = 0.; ///< Of the meshes, see PairBlock [m]
    double smallest_gap         = std::numeric_limits<double>::max(); ///< [m]
    /// Of the facets that overlap as candidates do; lowest() if none [m].
    double       largest_gap = std::numeric_limits<double>::lowest();
    std::string  force_on; ///< Single surface: part that force acts on.
    Tensor<1, 3> force;    ///< Resultant [N]
    Tensor<1, 3> moment;   ///< About the origin [N m]

    /// Contact force on one part, and its moment about the origin.
    struct Part
    {
      std::string  name;   ///< As given with add_secondary/primary.
      Tensor<1, 3> force;  ///< [N]
      Tensor<1, 3> moment; ///< [N m]
    };
    std::vector<Part> parts; ///< Of both sides.

    /// The deepest penetrations, one per secondary facet.
    std::vector<DeepPenetration> worst;

    /// Facets beyond the release depth in the present configuration.
    unsigned int n_too_deep = 0;
    /// Facets whose contact has been released since setup().
    unsigned int n_released            = 0;
    unsigned int n_augmentations       = 0; ///< In the present step.
    unsigned int n_augmentations_total = 0; ///< Since setup().

    /// Whether pairs have come since the last add_couplings().
    bool couplings_changed = true;

    double search_seconds = 0.; ///< Since setup(), slowest rank.
    /// The same for forces and tangents.
    double evaluate_seconds = 0.;

    /// The interface in one line.
    std::string
    brief() const;

    /// What was found at the start, a few lines.
    std::string
    initial_text() const;
  };
} // namespace MortarContact

#endif
