// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_initial_penetration_h
#define mortar_contact_laws_initial_penetration_h

#include <algorithm>
#include <string>

namespace MortarContact
{
  /// What is done about penetrations that are there at the start (IGNORE).
  enum class InitialPenetration
  {
    stress      = 0, ///< They give contact pressure at once.
    track       = 1, ///< The surface follows the opening, then is itself.
    ignore      = 2, ///< The surface stays at the penetrated level.
    remove      = 3, ///< The level goes back linearly over a time.
    remove_deep = 4  ///< As remove, for penetrations of any size.
  };

  /**
   * Offset o of the contact surface at a material point of the secondary; the
   * effective penetration is d - o. Before it acts, the offset is cut off at
   * zero: a point that was open at the start (negative level) is not shifted,
   * but interpolates exactly with its penetrated neighbours.
   *
   * @param level   State of the material point: the initial penetration
   *                (negative: an initial gap) [m], for `ignore` less the depth
   *                that gives the initial pressure (MPAR1), for `track` the
   *                smallest penetration of all converged states.
   * @param share   What is left of it at the present time, removal_share().
   */
  inline double
  offset(const double level, const double share)
  {
    return share * std::max(level, 0.);
  }

  /// Share of the initial penetration that is left at @p time [s] when it is
  /// removed linearly until @p removal_time (MPAR1) [s, positive].
  inline double
  removal_share(const InitialPenetration treatment,
                const double             time,
                const double             removal_time)
  {
    if (treatment == InitialPenetration::remove ||
        treatment == InitialPenetration::remove_deep)
      return std::min(1., std::max(0., 1. - time / removal_time));
    return (treatment == InitialPenetration::stress) ? 0. : 1.;
  }
} // namespace MortarContact

#endif
