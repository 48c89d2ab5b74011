// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_tie_sweep_h
#define mortar_contact_mortar_tie_sweep_h

#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/mortar/tie_kernel.h>

#include <vector>

namespace MortarContact
{
  /// What was tied on one rank, and what has become of it.
  struct TieCounts
  {
    double area        = 0.; ///< Of this rank's secondary facets [m^2]
    double tied_area   = 0.; ///< Tied at the start
    double whole_area  = 0.; ///< and not damaged now
    double failed_area = 0.; ///< or failed.
    /// Of facets that are tied in part: no contact there while they are.
    double       loose_area    = 0.;
    double       brittle       = 0.; ///< See TieLaw::brittleness().
    double       largest_gap   = 0.; ///< That was tied [m]
    double       dissipated    = 0.; ///< By damage, since the start [J]
    unsigned int n_free_facets = 0;  ///< Facets of which nothing was tied.
  };

  /// Where, around each secondary facet of this rank, TieSweep looks for
  /// primary facets.
  template <int dim>
  std::vector<Box<dim>>
  tie_regions(const Skin<dim> &secondary,
              const Skin<dim> &primary,
              const double     tolerance);

  /**
   * The ties between two skins: found once, in the undeformed configuration, by
   * the segments of the pairs of facets; then they stay. Ties know no search,
   * no clipping and no sliding.
   */
  template <int dim>
  class TieSweep
  {
  public:
    /// As those of contact.
    using ActivePair = typename ContactSweep<dim>::ActivePair;

    /**
     * Tie what is near.
     * @param scale     alpha of the contact stiffness alpha K/l.
     * @param tolerance Largest gap or overlap that is tied [m]; zero: 5 % of
     * the secondary facet's diameter.
     */
    TieSweep(const Skin<dim>       &secondary,
             const Skin<dim>       &primary,
             const TieStrength     &strength,
             const PairKernel<dim> &kernel,
             const double           scale,
             const double           tolerance);

    /// [secondary, primary] of all ties.
    const std::vector<std::pair<unsigned int, unsigned int>> &
    candidates() const
    {
      return pairs;
    }

    /// Forces of all ties in the present configuration.
    void
    evaluate(const bool with_tangent);

    /// Pairs of facets with ties that hold.
    const std::vector<ActivePair> &
    active_pairs() const
    {
      return active;
    }

    /// Accept the last evaluation.
    void
    commit();

    /// By secondary facet of this rank: whether a tie still holds it.
    std::vector<char>
    holds() const;

    /// Of the last evaluation.
    TieCounts
    counts() const;

    /// Largest jump of whole ties in the last evaluation, normal (opening
    /// positive) and tangential [m].
    double
    largest_opening() const
    {
      return opening;
    }

    /// What this rank's ties remember.
    TiesHistory<dim>
    history() const;

    /// Continue from the ties of all ranks: each tie takes over what the
    /// nearest of those saved remembers.
    /// @param keeps_sum Whether this rank counts what was dissipated.
    void
    continue_from(const TiesHistory<dim> &saved, const bool keeps_sum);

  private:
    Tensor<1, dim>
    undeformed_place(const unsigned int facet, const TiePoint<dim> &tie) const;

    const Skin<dim>  &secondary;
    const Skin<dim>  &primary;
    const TieLaw<dim> law;
    const bool        symmetrise;
    TieCounts         at_start;
    double            dissipated = 0.;
    double            opening    = 0.;

    std::vector<std::pair<unsigned int, unsigned int>> pairs;
    std::vector<std::vector<TiePoint<dim>>>            ties;  ///< By pair.
    std::vector<std::vector<TieHistory>>               trial; ///< By pair.
    std::vector<ActivePair>                            active;
  };
} // namespace MortarContact

#endif
