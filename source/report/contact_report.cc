// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/parameters/contact_parameters.h>
#include <mortar_contact/report/contact_report.h>

#include <sstream>

namespace MortarContact
{
  namespace
  {
    std::string
    in_words(const DeepPenetration &p)
    {
      std::ostringstream out;
      out << "cell " << p.secondary.cell << " of '" << p.secondary.part
          << "' at (" << p.position << ")";
      return out.str();
    }
  } // namespace


  std::string
  ContactReport::brief() const
  {
    std::ostringstream out;
    out.precision(4);
    out << "'" << name << "': " << active_pairs << " pairs, force "
        << (force_on.empty() ? "" : "on '" + force_on + "' ") << force.norm()
        << ", penetration " << largest_penetration << " ("
        << 100. * relative_penetration << " % of release)";
    if (slip_area > 0.)
      out << ", " << 100. * slip_area / active_area << " % slips";
    if (initial.tied_area > 0.)
      out << ", ties " << 100. * whole_tied_area / initial.tied_area
          << " % whole, " << 100. * failed_tied_area / initial.tied_area
          << " % failed";
    if (n_augmentations > 0)
      out << ", " << n_augmentations << " augmentations";
    if (n_too_deep > 0)
      out << ", " << n_too_deep << " facets beyond release";
    if (n_released > 0)
      out << ", " << n_released << " facets released so far";
    return out.str();
  }


  std::string
  ContactReport::initial_text() const
  {
    std::ostringstream out;
    out.precision(4);
    out << "Interface '" << name << "'\n";
    const char *const sides[2] = {"secondary", "primary"};
    for (unsigned int s = 0; s < 2; ++s)
      if (initial.highest_modulus[s] == 0.)
        {
          if (initial.n_side_facets[s] > 0)
            out << "  " << sides[s] << ": " << initial.n_side_facets[s]
                << " facets, rigid\n";
        }
      else
        out << "  " << sides[s] << ": " << initial.n_side_facets[s]
            << " facets, contact modulus " << initial.lowest_modulus[s]
            << " to " << initial.highest_modulus[s]
            << ", characteristic length " << initial.lowest_length[s] << " to "
            << initial.highest_length[s] << "\n";
    if (initial.n_turned > 0)
      out << "  " << initial.n_turned << " tool facets turned over\n";
    if (initial.n_facing_away > 0)
      out << "  WARNING: " << initial.n_facing_away
          << " facets of rigid surfaces point away from the secondary, which "
             "passes them unseen; turn them in the mesh, or give the rigid "
             "body a 'Thickness'\n";
    if (initial.secondary_area > 0.)
      {
        out << "  tied: " << 100. * initial.tied_area / initial.secondary_area
            << " % of the secondary's area, largest gap "
            << initial.largest_tied_gap << "\n";
        if (initial.loose_area > 1e-6 * initial.secondary_area)
          out
            << "  NOTE: " << 100. * initial.loose_area / initial.secondary_area
            << " % of the area belongs to facets that are tied in part; there "
               "is no contact there while a tie holds the facet\n";
        if (initial.n_free_facets > 0)
          out << "  NOTE: " << initial.n_free_facets
              << " secondary facets are not tied: nothing lies within 'Tie "
                 "tolerance'\n";
        return out.str();
      }
    if (initial.n_facets == 0 && initial.n_undetected == 0)
      {
        out << "  no initial penetrations\n";
        if (initial.asked_pressure > 0.)
          out << "  WARNING: 'Initial pressure' acts on initial penetrations "
                 "only: nothing is held. Where surfaces just touch, a small "
                 "'Secondary offset' makes them penetrate.\n";
      }
    if (initial.n_facets > 0)
      out << "  initial penetrations: " << initial.n_facets
          << " facets, deepest " << initial.deepest.penetration << " ("
          << 100. * initial.deepest.relative << " % of release), "
          << in_words(initial.deepest)
          << "; treatment: " << to_string(initial.treatment) << "\n";
    if (initial.n_undetected > 0)
      out << "  WARNING: " << initial.n_undetected
          << " facets penetrate by more than the release depth at the start, "
             "deepest "
          << initial.undetected.penetration << ", "
          << in_words(initial.undetected)
          << "; they have no contact until they separate. Consider 'Initial "
             "penetration = remove over time deep'.\n";
    return out.str();
  }
} // namespace MortarContact
