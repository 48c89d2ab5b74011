// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_contact_sweep_h
#define mortar_contact_mortar_contact_sweep_h

#include <mortar_contact/geometry/skin.h>
#include <mortar_contact/mortar/pair_kernel.h>
#include <mortar_contact/search/broad_phase.h>
#include <mortar_contact/state/contact_history.h>
#include <mortar_contact/state/surface_history.h>

#include <array>
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
    double         length   = 0.; ///< l there [m].
    unsigned int   facet    = 0;  ///< Secondary facet and
    Tensor<1, dim> position;      ///< place of the deepest.
    /// Facets that penetrate deeper than the release depth (or MPAR2) at the
    /// start, and are not treated therefore; the deepest.
    unsigned int   n_too_deep      = 0;
    double         too_deep        = 0.; ///< Depth of the deepest [m],
    double         too_deep_length = 0.; ///< characteristic length there [m],
    unsigned int   too_deep_facet  = 0;  ///< secondary facet,
    Tensor<1, dim> too_deep_position;    ///< and place [m].
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
   * One pass over an interface: points on this rank's facets of the secondary
   * skin, projected onto the primary skin. Of other ranks' facets it must know
   * those that lie in regions(). Holds the candidate pairs, the
   * results of the last evaluation, and the history.
   */
  template <int dim>
  class ContactSweep
  {
  public:
    /// A pair with contact.
    struct ActivePair
    {
      unsigned int   secondary; ///< Facet,
      unsigned int   primary;   ///< and facet.
      PairBlock<dim> block;     ///< Forces and derivatives.
    };

    /// Counts of the last evaluation, this rank.
    struct Counts
    {
      unsigned int active     = 0; ///< With a penetration.
      unsigned int open       = 0; ///< Overlap, but a gap.
      unsigned int apart      = 0; ///< No overlap.
      unsigned int beyond     = 0; ///< Points behind the other surface.
      unsigned int degenerate = 0; ///< Without a usable shape.
      /// Of open pairs [m].
      double smallest_gap = std::numeric_limits<double>::max();
      /// Of all pairs that overlap [m].
      double largest_gap = std::numeric_limits<double>::lowest();
      double overlap     = 0.; ///< Largest depth of the meshes [m].
    };

    /// @param friction Null: none, and nothing of it is stored.
    /// @param obstacle Primary without facets; null: the skin @p primary.
    /// @param weight Share of the contact energy: 1, or 1/2 for each of two.
    ContactSweep(const Skin<dim>     &secondary,
                 const Skin<dim>     &primary,
                 const Obstacle<dim> *obstacle,
                 const PressureLaw   &law,
                 const FrictionLaw   *friction,
                 const KernelOptions &options,
                 const double         weight);

    /// Whether facets have moved so far since the last search that pairs may
    /// be missing. Local to the rank.
    bool
    needs_search() const;

    /// Find all candidate pairs in the present configuration.
    void
    search();

    /// Where, around each facet of this rank, primary facets may be candidates
    /// of a search() in the present configuration, or candidates_after().
    std::vector<Box<dim>>
    regions(const double diameters) const;

    /// Where detect_initial() looks.
    std::vector<Box<dim>>
    initial_regions(const InitialTreatment &treatment) const;

    /// Where safe_step() looks for motions of the secondary facets to
    /// @p moved.
    std::vector<Box<dim>>
    swept_regions(const std::vector<Facet<dim>> &moved) const;

    /// Facets of other ranks have come to the primary skin; where they were at
    /// the end of the last accepted step (friction only).
    void
    remember_primary(const std::vector<Facet<dim>> &before);

    /// [secondary, primary], ascending; an obstacle counts as primary 0.
    const std::vector<std::pair<unsigned int, unsigned int>> &
    candidates() const
    {
      return pairs;
    }

    /// candidates(), and those that would come if facets moved by so many of
    /// their mean diameters.
    std::vector<std::pair<unsigned int, unsigned int>>
    candidates_after(const double diameters) const;

    /// Find initial penetrations, and store them where the treatment says so.
    InitialFindings<dim>
    detect_initial(const InitialTreatment &treatment);

    /// Evaluate all candidates in the present configuration.
    /// @param share What is left of the initial penetrations.
    /// @param time_step Since the last commit() [s]; zero: unknown.
    void
    evaluate(const double share,
             const double time_step,
             const bool   with_tangent);

    /// Pairs with a penetration at the last evaluation.
    const std::vector<ActivePair> &
    active_pairs() const
    {
      return active;
    }

    /// Of the last evaluation.
    const Counts &
    counts() const
    {
      return last_counts;
    }

    /// Secondary facets whose penetration exceeds @p largest_share of l.
    std::vector<unsigned int>
    too_deep(const double largest_share) const;

    /// Take active pairs (by number, not 0) back: they are no contact, and from
    /// commit() on no candidates until their facets no longer lie over each
    /// other.
    void
    set_aside(const std::vector<char> &active_pairs);

    /**
     * What another rule of integration would change of the last evaluation: the
     * sum over facets in contact, @p most_facets of them or all, of how much
     * the normal forces on their vertices differ, and the sum of the larger of
     * both [N].
     */
    std::array<double, 2>
    compare(const Integration &other, const unsigned int most_facets) const;

    /// Accept the present configuration: follow openings if @p track, drop the
    /// contact of the facets in @p released, re-admit released facets that have
    /// opened, keep slip and augmentation.
    void
    commit(const bool track, const std::vector<unsigned int> &released);

    /// Forget what was augmented since the last commit().
    void
    rollback();

    /**
     * One step of Uzawa's method: pressures become those that act, depths
     * start again from zero. The pressure p at a material point is kept as the
     * depth A that gives it, p = law(d + A): A <- max(0, A + d).
     */
    void
    augment();

    /// Largest |d| at the material points in contact (d + A > 0) [m].
    double
    penetration() const;

    /// Hold facets by ties, or let go of them: held facets have no contact.
    /// By facet of this rank.
    void
    set_tied(const std::vector<char> &is_held);

    /**
     * Largest factor in (0, 1] for a motion of all facets by which no facet
     * approaches another by more than their gap plus half the characteristic
     * length.
     * @param moved_s,moved_p Facets after the full motion.
     */
    double
    safe_step(const std::vector<Facet<dim>> &moved_s,
              const std::vector<Facet<dim>> &moved_p) const;

    /// The same against an obstacle that goes to @p motion meanwhile.
    double
    safe_step_to_obstacle(const std::vector<Facet<dim>> &moved,
                          const RigidMotion<dim>        &motion) const;

    /// What is left of the initial penetrations at the start; after
    /// detect_initial().
    void
    start(const double share);

    /// Of the last accepted step.
    const ContactHistory<dim> &
    state() const
    {
      return history;
    }

    /// Whether facets of this rank remember anything.
    bool
    remembers() const;

    /// What this rank remembers, free of numbers.
    /// @param with_facets If those of any rank remember something: what has no
    ///                    entry would be taken from its neighbours.
    SurfaceHistory<dim>
    surface_history(const bool with_facets) const;

    /**
     * Continue from the histories of all ranks' facets, on whatever mesh they
     * were. A facet with the same vertices takes over what it was; material
     * points of others get what the saved ones say where they are. The skins
     * must be where they were accepted.
     * @param follows_openings Levels on another mesh are those saved (treatment
     *        `track`); else those that detect_initial() found on this one.
     */
    void
    continue_from(const SurfaceHistory<dim> &saved,
                  const bool                 follows_openings);

  private:
    std::vector<FacetHistory<dim>>
    facet_histories() const;

    /// Pairs of facets of this mesh that are parts of the pairs saved.
    std::vector<std::pair<unsigned int, unsigned int>>
    pairs_like(
      const std::vector<typename SurfaceHistory<dim>::PairAside> &saved) const;

    void
    restore(const ContactHistory<dim> &saved);

    /// State of a facet of this rank; @p slip is filled where there is
    /// friction, and must outlive the result.
    SecondaryState<dim>
    state_of(const unsigned int f, FacetSlip<dim> &slip) const;

    /// Candidates that are set aside are none.
    void
    drop_pairs_aside();

    /// Take over pairs that were set aside, readmit those that have parted.
    void
    commit_pairs_aside();

    bool
    is_released(const unsigned int f) const;

    /// Released or tied.
    bool
    has_no_contact(const unsigned int f) const;

    const Facet<dim> *
    primary_before(const unsigned int p) const;

    /// The primary's surface where a secondary point sees it.
    PrimaryPoint<dim>
    primary_point(const unsigned int                   p,
                  const typename PairKernel<dim>::Hit &at) const;

    /// Where the line through a secondary point meets a primary facet, or the
    /// obstacle.
    std::optional<typename PairKernel<dim>::Hit>
    hit(const SecondaryFrame<dim> &frame,
        const PlanePoint<dim>     &xi,
        const unsigned int         p,
        const double               range) const;

    /// Prepare the slip of all facets of this rank for the next step.
    void
    store_before();

    void
    update_slip();

    /// The part of the slip that does not change within a step.
    void
    prepare_slips();

    /// How far a secondary point looks for an obstacle.
    double
    far_of(const SecondaryFrame<dim> &frame) const;

    /// Effective depth at the material points of facet @p f; lowest number: out
    /// of sight.
    std::vector<double>
    depths_at_points(const unsigned int f, unsigned int &next) const;

    /// False if a facet is surely out of the obstacle's reach.
    bool
    may_meet_obstacle(const unsigned int f) const;

    void
    count(const PairBlock<dim> &block);

    void
    evaluate_points(const bool with_tangent);

    /// Depth below a surface [m], negative in front of it, and what acts there.
    struct Depth
    {
      double                        depth;
      ContactStiffness              stiffness;
      unsigned int                  primary;
      typename PairKernel<dim>::Hit hit;
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
      /// At the material points that see the other surface. Where the facet
      /// overlaps in part, at all of them, of a function that is right at its
      /// corners.
      std::vector<std::optional<Depth>> at_points;
      /// Of the points or, if these lie open, of the corners.
      std::optional<Depth> deepest;
      Tensor<1, dim>       position; ///< Of the deepest.
      /// Whether the points see gaps, and only corners overlap.
      bool of_corners_only = false;
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

    /// Pairs that may touch after motions of @p motion [m] from where the last
    /// search was.
    std::vector<std::pair<unsigned int, unsigned int>>
    find_pairs(const double motion) const;

    /// Motion that candidates after @p diameters allow for [m].
    double
    motion_of(const double diameters) const;

    /// Where candidates of a facet lie after motions of @p motion [m].
    Box<dim>
    region_of(const unsigned int f,
              const Facet<dim>  &facet,
              const double       motion) const;

    /// Depths up to which initial penetrations of a facet are treated, and
    /// looked for [m].
    std::array<double, 2>
    initial_ranges(const unsigned int         f,
                   const SecondaryFrame<dim> &frame,
                   const InitialTreatment    &treatment) const;

    Box<dim>
    initial_region(const unsigned int      f,
                   const InitialTreatment &treatment) const;

    Box<dim>
    swept_region(const unsigned int f, const Facet<dim> &moved) const;

    /// Candidates of facet @p f from pair @p next on; moves @p next.
    std::vector<unsigned int>
    candidates_of(const unsigned int f, unsigned int &next) const;

    const Skin<dim>     &secondary;
    const Skin<dim>     &primary;
    const Obstacle<dim> *obstacle;
    const PressureLaw   &law;
    PairKernel<dim>      kernel;
    double               weight;
    double               margin; ///< Motion that candidates allow for [m].
    double               surface_offset;     ///< Of both sides [m].
    double               deepest_level = 0.; ///< Of the history [m].

    double                      last_reach = 0.; ///< Largest, last search [m]
    double                      last_share = 0.; ///< Of the last evaluation.
    double                      last_time_step = 0.;
    std::vector<FacetSlip<dim>> slips; ///< Friction only.

    ContactHistory<dim>                                history;
    std::vector<VertexValues<dim>>                     augmentation; ///< Trial.
    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    std::vector<Facet<dim>>                            searched_s, searched_p;
    std::vector<ActivePair>                            active;

    /// Set aside since the last evaluation.
    std::vector<std::pair<unsigned int, unsigned int>> new_aside;
    Counts                                             last_counts;
  };
} // namespace MortarContact

#endif
