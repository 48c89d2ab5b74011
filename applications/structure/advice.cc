// SPDX-License-Identifier: LGPL-2.1-or-later
#include "advice.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Structure
{
  namespace
  {
    /// A penalty's share that deserves a word, and the one that is proposed.
    constexpr double large_share = 0.05, good_share = 0.02;

    /// The rule's share of the forces on facets that deserves one. Forces on
    /// single facets differ more than their sums do.
    constexpr double large_integration_error = 0.1;

    /// Rejected tries per step, Newton iterations per step, the contact's share
    /// of the time and a time [s] from which on they deserve one.
    constexpr double many_cut_backs = 0.5, many_iterations = 10.,
                     large_contact_time = 0.5, long_run = 60.;

    /// To one digit.
    std::string
    rounded(const double x)
    {
      const double       unit = std::pow(10., std::floor(std::log10(x)));
      std::ostringstream out;
      out << std::round(x / unit) * unit;
      return out.str();
    }

    std::string
    percent(const double share)
    {
      std::ostringstream out;
      out << std::fixed << std::setprecision(share < 0.095 ? 1 : 0)
          << 100. * share << " %";
      return out.str();
    }
  } // namespace


  double
  penalty_share(const RunFigures &run, const RunFigures::Interface &interface)
  {
    double all = run.strain_energy;
    for (const RunFigures::Interface &i : run.interfaces)
      all += i.energy;
    // Uzawa's energy is that of the pressures, not of the penetrations
    return (run.strain_energy > 0. && interface.energy > 0. &&
            !interface.parameters->augmentation.is_on) ?
             interface.energy / all :
             0.;
  }


  std::vector<std::string>
  advice(const RunFigures &run)
  {
    std::vector<std::string> sentences;
    for (const RunFigures::Interface &i : run.interfaces)
      {
        const double share = penalty_share(run, i);
        // glue may well be meant to be soft
        if (share < large_share || i.parameters->has_ties())
          continue;
        // At a given pressure the energy of a spring p = k d^n falls with
        // k^(-1/n).
        const double n = (i.parameters->law == "linear") ? 1. : 2.;
        const double ratio =
          (i.energy / run.strain_energy) / (good_share / (1. - good_share));
        sentences.push_back(
          "ACCURACY: the penalty of '" + i.name + "' holds " + percent(share) +
          " of the elastic energy; forces (or motions, where forces are given) "
          "may be wrong by as much. 'Contact/" +
          i.name + "/Stiffness scale = " +
          rounded(i.parameters->stiffness_scale * std::pow(ratio, n)) +
          "' would make it about " + percent(good_share) +
          (n == 1. ? "." :
                     ", 'Law = linear' needs less; 'Augmentation = Uzawa' "
                     "iterates to a 'Penetration tolerance'."));
      }
    for (const RunFigures::Interface &i : run.interfaces)
      if (!i.has_touched && run.steps > 0)
        {
          std::ostringstream gap;
          gap.precision(4);
          gap << i.smallest_gap;
          sentences.push_back(
            "NOTE: '" + i.name + "' was never in contact" +
            (i.smallest_gap < std::numeric_limits<double>::max() ?
               "; its smallest gap is " + gap.str() + "." :
               ": its surfaces never faced each other within reach. Are they "
               "the right ones, does the motion go the right way?"));
        }
    for (const RunFigures::Interface &i : run.interfaces)
      if (i.integration_error > large_integration_error)
        {
          using Rule      = MortarContact::Integration::Rule;
          const Rule rule = (i.is_on_obstacle &&
                             i.parameters->integration.rule == Rule::segments) ?
                              Rule::points :
                              i.parameters->integration.rule;
          sentences.push_back(
            "ACCURACY: a finer rule of integration would change the forces on "
            "the facets of '" +
            i.name + "' by " + percent(i.integration_error) + "; " +
            (rule == Rule::segments ? "finer facets help, or 'Degree = 6'." :
             rule == Rule::points   ? "more 'Points per direction' help, or "
                                      "'Integration = segments' between meshes." :
                                      "'Integration = segments' has no such "
                                      "error."));
        }
    if (run.energy_growth > large_energy_growth)
      sentences.push_back("ACCURACY: energy grew by " +
                          percent(run.energy_growth) +
                          " of its largest value out of nothing; a smaller "
                          "'Steps/Largest step', at most a twentieth of the "
                          "time that an impact takes, avoids it.");
    const double steps = std::max(run.steps, 1u);
    if (run.cut_backs > many_cut_backs * steps)
      sentences.push_back("SPEED: " + std::to_string(run.cut_backs) +
                          " tries were rejected in " +
                          std::to_string(run.steps) +
                          " steps; their reasons are above. See "
                          "doc/when_it_does_not_converge.md.");
    else if (run.steps > 1 && run.iterations > many_iterations * steps)
      sentences.push_back(
        "SPEED: " + std::to_string(run.iterations) + " iterations in " +
        std::to_string(run.steps) + " steps." +
        (run.is_static && !run.predicts ?
           " Where something moves steadily, 'Solver/Newton/Predictor = "
           "linear' saves many." :
           " See doc/when_it_does_not_converge.md."));
    if (run.all_seconds > long_run &&
        run.contact_seconds > large_contact_time * run.all_seconds)
      sentences.push_back("SPEED: contact takes " +
                          percent(run.contact_seconds / run.all_seconds) +
                          " of the time; 'Integration = points' costs less on "
                          "fine meshes, and is rougher.");
    return sentences;
  }
} // namespace Structure
