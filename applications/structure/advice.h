// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_advice_h
#define mortar_contact_structure_advice_h

#include <mortar_contact/parameters/contact_parameters.h>

#include <string>
#include <vector>

namespace Structure
{
  /// Energy from nowhere, over the largest energy, that deserves a word.
  constexpr double large_energy_growth = 0.05;

  /// What a run knows about itself at its end.
  struct RunFigures
  {
    struct Interface
    {
      std::string                             name;
      const MortarContact::ContactParameters *parameters;
      double                                  energy; ///< Of its springs [J].
      /// See ContactInterface::integration_error().
      double integration_error;
      bool   is_on_obstacle; ///< Points on a smooth rigid surface.
      bool   has_touched;    ///< In some step.
      double smallest_gap;   ///< At the end [m]
    };

    std::vector<Interface> interfaces;
    double                 strain_energy   = 0.; ///< Of all bodies [J].
    unsigned int           steps           = 0;
    unsigned int           iterations      = 0; ///< Also of rejected tries.
    unsigned int           cut_backs       = 0;
    bool                   predicts        = false;
    bool                   is_static       = true;
    double                 energy_growth   = 0.; ///< See Simulation.
    double                 contact_seconds = 0.; ///< Search and evaluation.
    double                 all_seconds     = 0.;
  };

  /**
   * Share of the elastic energy that is in the springs of the penalty [-]: the
   * relative error of forces (where motions are given) or motions (where forces
   * are), since a body and the contact in front of it are springs in series.
   */
  double
  penalty_share(const RunFigures &run, const RunFigures::Interface &interface);

  /**
   * Sentences about what made a run inaccurate or slow, and what to change;
   * none for most runs.
   */
  std::vector<std::string>
  advice(const RunFigures &run);
} // namespace Structure

#endif
