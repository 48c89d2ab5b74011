// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_contact_sweep_h
#define mortar_contact_mortar_contact_sweep_h

#include <mortar_contact/geometry/skin.h>
#include <mortar_contact/mortar/pair_kernel.h>
#include <mortar_contact/state/contact_history.h>

#include <utility>
#include <vector>

namespace MortarContact
{
  /// Initial penetrations found on one rank in one sweep.
  template <int dim>
  struct InitialFindings
  {
    unsigned int   n_facets = 0;  ///< Facets that penetrate.
    double         depth    = 0.; ///< Deepest penetration found [m].
    unsigned int   facet    = 0;  ///< Secondary facet and
    Tensor<1, dim> position;      ///< place of the deepest.
    /// Facets that penetrate deeper than the release depth (or MPAR2) at the
    /// start, and are not treated therefore; the deepest.
    unsigned int   n_too_deep     = 0;
    double         too_deep       = 0.;
    unsigned int   too_deep_facet = 0;
    Tensor<1, dim> too_deep_position;
  };

  /// How a sweep treats what it finds at the start.
  struct InitialTreatment
  {
    /// Penetrations up to this share of l count (release depth) ...
    double largest_share = 0.5;
    /// ... or, if positive, up to this depth (MPAR2) [m].
    double deepest = 0.;
    /// Pressure that stays (MPAR1 of `ignore`) [Pa].
    double remaining_pressure = 0.;
    /// Whether levels are stored at all (not for `stress`).
    bool store = false;
  };

  /**
   * One pass over an interface: points on the owned facets of the secondary
   * skin, projected onto the primary skin. Holds the candidate pairs, the
   * results of the last evaluation, and the history.
   */
  template <int dim>
  class ContactSweep
  {
  public:
    /// A pair with contact.
    struct ActivePair
    {
      unsigned int   secondary, primary; ///< Facets.
      PairBlock<dim> block;
    };

    /// Counts of the last evaluation, this rank.
    struct Counts
    {
      unsigned int active = 0, open = 0, apart = 0, beyond = 0, degenerate = 0;
      double       smallest_gap = std::numeric_limits<double>::max();
      double       overlap      = 0.;
    };

    /// @param weight Share of the contact energy: 1, or 1/2 for each of two.
    ContactSweep(const Skin<dim>     &secondary,
                 const Skin<dim>     &primary,
                 const PressureLaw   &law,
                 const KernelOptions &options,
                 const double         weight);

    /// Whether facets have moved so far since the last search that pairs may
    /// be missing. Local to the rank.
    bool
    needs_search() const;

    /// Find all candidate pairs in the present configuration.
    void
    search();

    /// [secondary, primary], ascending.
    const std::vector<std::pair<unsigned int, unsigned int>> &
    candidates() const
    {
      return pairs;
    }

    /// Find initial penetrations, and store them where the treatment says so.
    InitialFindings<dim>
    detect_initial(const InitialTreatment &treatment);

    /// Evaluate all candidates in the present configuration.
    /// @param share What is left of the initial penetrations.
    void
    evaluate(const double share, const bool with_tangent);

    const std::vector<ActivePair> &
    active_pairs() const
    {
      return active;
    }

    const Counts &
    counts() const
    {
      return last_counts;
    }

    /// Secondary facets whose penetration exceeds @p largest_share of l.
    std::vector<unsigned int>
    too_deep(const double largest_share) const;

    /// Accept the present configuration: follow openings if @p track, drop the
    /// contact of the facets in @p released, re-admit released facets that have
    /// opened.
    void
    commit(const bool track, const std::vector<unsigned int> &released);

    /**
     * Largest factor in (0, 1] for a motion of all facets by which no facet
     * approaches another by more than their gap plus half the characteristic
     * length.
     * @param moved_s,moved_p Facets after the full motion.
     */
    double
    safe_step(const std::vector<Facet<dim>> &moved_s,
              const std::vector<Facet<dim>> &moved_p) const;

    const ContactHistory<dim> &
    state() const
    {
      return history;
    }

    /// Continue from a saved state().
    void
    restore(const ContactHistory<dim> &saved);

  private:
    FacetOffset<dim>
    offset_of(const unsigned int owned, const double share) const;

    bool
    is_released(const unsigned int owned) const;

    void
    count(const PairBlock<dim> &block);

    void
    evaluate_points(const double share, const bool with_tangent);

    /// Depth below a surface [m], negative in front of it, and what acts there.
    struct Depth
    {
      double           depth;
      ContactStiffness stiffness;
    };

    /// Depth below the nearest facing primary facet along the normal at @p xi,
    /// at most @p deepest.
    std::optional<Depth>
    depth_at(const SecondaryFrame<dim>       &frame,
             const PlanePoint<dim>           &xi,
             const unsigned int               secondary_facet,
             const std::vector<unsigned int> &among,
             const double                     deepest) const;

    /// Depths on one facet.
    struct FacetDepths
    {
      /// At the material points that see the other surface.
      std::vector<std::optional<Depth>> at_points;
      /// Of these or, if there is none, of the corners.
      std::optional<Depth> deepest;
      Tensor<1, dim>       position; ///< Of the deepest.

      /// At a material point; one that sees nothing goes with the deepest.
      const std::optional<Depth> &
      of_point(const unsigned int q) const
      {
        return at_points[q] ? at_points[q] : deepest;
      }
    };

    FacetDepths
    depths_of(const unsigned int               secondary_facet,
              const std::vector<unsigned int> &among,
              const double                     deepest) const;

    /// Largest characteristic length that can act on a secondary facet.
    double
    longest(const unsigned int secondary_facet) const;

    /// Largest depth at which the points of a secondary facet see anything.
    double
    reach(const unsigned int secondary_facet) const;

    const Skin<dim>   &secondary;
    const Skin<dim>   &primary;
    const PressureLaw &law;
    PairKernel<dim>    kernel;
    double             weight;
    double             margin; ///< Motion that candidates allow for [m].
    double             largest_length_p     = 0.; ///< Of the primary [m].
    double             largest_compliance_p = 0.; ///< [m/Pa]
    double             surface_offset       = 0.; ///< Of both sides [m].
    double             deepest_level        = 0.; ///< Of the history [m].

    ContactHistory<dim>                                history;
    std::vector<unsigned int>                          owned;
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    std::vector<Facet<dim>>                            searched_s, searched_p;
    std::vector<ActivePair>                            active;
    Counts                                             last_counts;
  };
} // namespace MortarContact

#endif
