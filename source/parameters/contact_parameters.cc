// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/law_library.h>
#include <mortar_contact/parameters/contact_parameters.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <array>
#include <cmath>
#include <utility>

namespace MortarContact
{
  namespace
  {
    const std::array<const char *, 5> treatments = {{"stress",
                                                     "track",
                                                     "ignore",
                                                     "remove over time",
                                                     "remove over time deep"}};

    const std::array<const char *, 5> kinds = {{"forming surface to surface",
                                                "automatic surface to surface",
                                                "automatic single surface",
                                                "tied",
                                                "tiebreak"}};

    /// Names joined for a selection pattern.
    template <class Names>
    std::string
    alternatives(const Names &names)
    {
      std::string result;
      for (const auto &name : names)
        result += (result.empty() ? "" : "|") + std::string(name);
      return result;
    }

    std::string
    law_names()
    {
      std::vector<std::string> names;
      for (const auto &law : pressure_laws())
        names.push_back(law.first);
      return alternatives(names);
    }
  } // namespace


  std::string
  to_string(const InitialPenetration treatment)
  {
    return treatments[static_cast<unsigned int>(treatment)];
  }


  void
  ContactParameters::declare(ParameterHandler &prm)
  {
    const ContactParameters d;
    const Patterns::Double  positive_or_zero(0.);

    prm.declare_entry(
      "Kind",
      kinds[static_cast<unsigned int>(d.kind)],
      Patterns::Selection(alternatives(kinds)),
      "Forming: points on the secondary only, stiffness of the secondary, "
      "primary normals point to the secondary. Automatic surface to surface: "
      "both sides in turn at half weight, so that it does not matter which is "
      "which; twice the cost. Single surface: the secondary's parts against each "
      "other and themselves. Tied: no relative motion. Tiebreak: tied until it "
      "fails. (FORMING_, AUTOMATIC_SURFACE_TO_SURFACE_MORTAR, "
      "AUTOMATIC_SINGLE_SURFACE_MORTAR, _MORTAR_TIED, _TIEBREAK_MORTAR)");
    prm.declare_entry(
      "Integration",
      "segments",
      Patterns::Selection("segments|points|nodes"),
      "segments: over the overlaps of facets, exact for plane facets. points: "
      "at points fixed on the secondary, without clipping; cheaper and rougher. "
      "nodes: at the secondary's nodes (node-to-segment), for comparison.");
    prm.declare_entry("Degree",
                      std::to_string(d.integration.degree),
                      Patterns::Integer(2, 6),
                      "Degree of the rule on segments [-].");
    prm.declare_entry("Points per direction",
                      std::to_string(d.integration.points_per_direction),
                      Patterns::Integer(1, 20),
                      "Points per direction for Integration = points [-].");
    prm.declare_entry("Law",
                      d.law,
                      Patterns::Selection(law_names()),
                      "Contact pressure over penetration.");
    prm.declare_entry("Stiffness scale",
                      "1.0",
                      Patterns::Double(1e-12),
                      "Factor on the contact pressure [-] (SFS).");
    prm.declare_entry("Penalty factor",
                      "0.1",
                      Patterns::Double(1e-12),
                      "Contact stiffness of a facet over that of the cell "
                      "behind it [-] (SLSFAC).");
    prm.declare_entry("Stiffness",
                      "0.0",
                      positive_or_zero,
                      "Contact modulus of both sides [pressure]; 0: the bulk "
                      "modulus of each cell's material (SLDSTF).");
    prm.declare_entry(
      "Stiffness side",
      d.stiffness_side,
      Patterns::Selection("automatic|secondary|series"),
      "secondary: as LS-DYNA, put the softer body there. series: "
      "both as springs in series. automatic: secondary for "
      "forming, series for automatic kinds.");
    prm.declare_entry(
      "Characteristic length",
      d.characteristic_length,
      Patterns::Anything(),
      "Length that makes penetration relative: local (height of each cell over "
      "its facet), shortest edge (of the part, as LS-DYNA), or a value "
      "[length] (SST for solids).");
    prm.declare_entry(
      "Progressive stiffening",
      "1.0",
      Patterns::Double(1.),
      "Factor on the pressure at the largest penetration, grows "
      "from half of it on [-]; 1: none (IGAP).");
    prm.declare_entry("Largest penetration",
                      "0.0",
                      positive_or_zero,
                      "Penetration at which contact is released [length]; 0: "
                      "half the characteristic length (PENMAX).");
    prm.declare_entry("Release",
                      "cut back",
                      Patterns::Selection("report|cut back|never"),
                      "When a converged state exceeds the largest penetration: "
                      "report and drop the contact of these facets, or reject "
                      "the step and cut it back. never: the pressure grows "
                      "without bound before it is reached. Facets that come "
                      "to lie over each other from the side, like a shell's "
                      "top and its neighbour's bottom when their edges push "
                      "into each other, are no contact until they part.");
    prm.declare_entry("Thickness",
                      "0.0",
                      Patterns::Double(0.),
                      "That shells have for contact [length]; 0: their own "
                      "(SST for shells).");
    prm.declare_entry("Thickness scale",
                      "1.0",
                      Patterns::Double(0.),
                      "Factor on the thickness of shells for contact [-] "
                      "(SFST).");
    prm.declare_entry("Secondary offset",
                      "0.0",
                      Patterns::Double(),
                      "Contact surface in front of the secondary's mesh "
                      "[length] (SLDTHK).");
    prm.declare_entry(
      "Primary offset",
      "0.0",
      Patterns::Double(),
      "Contact surface in front of the primary's mesh [length].");
    prm.declare_entry("Initial penetration",
                      "stress",
                      Patterns::Selection(alternatives(treatments)),
                      "Treatment of penetrations that are there at the start "
                      "(IGNORE 0, 1, 2, 3, 4).");
    prm.declare_entry(
      "Initial pressure",
      "0.0",
      positive_or_zero,
      "Contact pressure at the start where Initial penetration = "
      "ignore [pressure] (MPAR1).");
    prm.declare_entry("Removal time",
                      "0.0",
                      positive_or_zero,
                      "Time at which initial penetrations are removed [time] "
                      "(MPAR1).");
    prm.declare_entry("Deepest initial penetration",
                      "0.0",
                      positive_or_zero,
                      "Upper bound of the initial penetrations for remove over "
                      "time deep [length]; deeper ones are an error (MPAR2).");
    FrictionParameters::declare(prm);
    TieParameters::declare(prm);
    prm.declare_entry("Augmentation",
                      "none",
                      Patterns::Selection("none|Uzawa"),
                      "Uzawa: repeat each step with the pressures it has found "
                      "until penetrations are below the tolerance.");
    prm.declare_entry("Penetration tolerance",
                      "0.0",
                      positive_or_zero,
                      "Of Augmentation = Uzawa [length].");
    prm.declare_entry("Largest number of augmentations",
                      std::to_string(d.augmentation.most),
                      Patterns::Integer(1, 1000),
                      "Per step, then the step is rejected [-].");
    prm.declare_entry("Tool normals",
                      "check",
                      Patterns::Selection("check|turn"),
                      "Forming contact: facets of a rigid tool that point away "
                      "from the blank are an error, or are turned.");
    prm.declare_entry("Penetration report every",
                      "1",
                      Patterns::Integer(0),
                      "Steps between reports of the worst penetrations [-]; 0: "
                      "none (MINFO).");
    prm.declare_entry("Number of worst facets",
                      "3",
                      Patterns::Integer(0, 1000),
                      "Facets listed in each penetration report [-].");
    prm.declare_entry("Tangent",
                      "exact",
                      Patterns::Selection("symmetric|exact"),
                      "exact: the derivative of the contact forces, nearly "
                      "symmetric but for sharp edges. symmetric: its symmetric "
                      "part, for symmetric linear solvers; more iterations.");
  }


  void
  ContactParameters::read(ParameterHandler &prm)
  {
    for (unsigned int i = 0; i < kinds.size(); ++i)
      if (prm.get("Kind") == kinds[i])
        kind = static_cast<Kind>(i);
    const std::string rule = prm.get("Integration");
    integration.rule       = (rule == "points") ? Integration::Rule::points :
                             (rule == "nodes")  ? Integration::Rule::nodes :
                                                  Integration::Rule::segments;
    integration.degree     = prm.get_integer("Degree");
    integration.points_per_direction = prm.get_integer("Points per direction");
    law                              = prm.get("Law");
    stiffness_scale                  = prm.get_double("Stiffness scale");
    penalty_factor                   = prm.get_double("Penalty factor");
    modulus                          = prm.get_double("Stiffness");
    stiffness_side                   = prm.get("Stiffness side");
    characteristic_length            = prm.get("Characteristic length");
    progressive_stiffening           = prm.get_double("Progressive stiffening");
    largest_penetration              = prm.get_double("Largest penetration");
    const std::string at_release     = prm.get("Release");
    release = (at_release == "report") ? Release::report :
              (at_release == "never")  ? Release::never :
                                         Release::cut_back;
    friction.read(prm);
    tie.read(prm);
    augmentation.is_on     = prm.get("Augmentation") == "Uzawa";
    augmentation.tolerance = prm.get_double("Penetration tolerance");
    augmentation.most      = prm.get_integer("Largest number of augmentations");
    tool_normals    = (prm.get("Tool normals") == "turn") ? ToolNormals::turn :
                                                            ToolNormals::check;
    thickness       = prm.get_double("Thickness");
    thickness_scale = prm.get_double("Thickness scale");
    AssertThrow(thickness_scale > 0.,
                ExcMessage("'Thickness scale' is 0; expected a positive "
                           "number."));
    secondary_offset = prm.get_double("Secondary offset");
    primary_offset   = prm.get_double("Primary offset");
    for (unsigned int i = 0; i < treatments.size(); ++i)
      if (prm.get("Initial penetration") == treatments[i])
        initial_penetration = static_cast<InitialPenetration>(i);
    initial_pressure    = prm.get_double("Initial pressure");
    removal_time        = prm.get_double("Removal time");
    deepest_penetration = prm.get_double("Deepest initial penetration");
    report_every        = prm.get_integer("Penetration report every");
    n_worst_facets      = prm.get_integer("Number of worst facets");
    symmetric_tangent   = prm.get("Tangent") == "symmetric";
    check();
  }


  void
  ContactParameters::check() const
  {
    // what patterns say of a file's entries, for hosts without one
    const auto expect = [](const bool         ok,
                           const std::string &name,
                           const double       value,
                           const char        *expected) {
      AssertThrow(ok,
                  ExcMessage("'" + name + "' is " + std::to_string(value) +
                             "; expected " + expected + "."));
    };
    const auto positive = [&](const std::string &name, const double value) {
      expect(value > 0. && std::isfinite(value),
             name,
             value,
             "a positive number");
    };
    const auto not_negative = [&](const std::string &name, const double value) {
      expect(value >= 0. && std::isfinite(value), name, value, "0 or more");
    };
    positive("Stiffness scale", stiffness_scale);
    positive("Penalty factor", penalty_factor);
    positive("Thickness scale", thickness_scale);
    expect(progressive_stiffening >= 1. &&
             std::isfinite(progressive_stiffening),
           "Progressive stiffening",
           progressive_stiffening,
           "1 or more");
    not_negative("Largest penetration", largest_penetration);
    not_negative("Thickness", thickness);
    not_negative("Friction coefficient", friction.coefficient);
    not_negative("Elastic slip", friction.elastic_slip);
    expect(augmentation.most > 0,
           "Largest number of augmentations",
           augmentation.most,
           "1 or more");
    AssertThrow(stiffness_side == "automatic" || stiffness_side == "series" ||
                  stiffness_side == "secondary",
                ExcMessage("'Stiffness side' is '" + stiffness_side +
                           "'; expected automatic, series or secondary."));

    const std::string treatment =
      "'Initial penetration' is '" + to_string(initial_penetration) + "'";
    const bool removes = initial_penetration == InitialPenetration::remove ||
                         initial_penetration == InitialPenetration::remove_deep;
    const bool deep = initial_penetration == InitialPenetration::remove_deep;

    AssertThrow(!removes || removal_time > 0.,
                ExcMessage(
                  treatment +
                  " but 'Removal time' (MPAR1) is 0; give the positive "
                  "time at which penetrations are gone."));
    AssertThrow(!deep || deepest_penetration > 0.,
                ExcMessage(treatment +
                           " but 'Deepest initial penetration' (MPAR2) is 0; "
                           "give an upper bound of the initial penetrations."));
    AssertThrow(deep || deepest_penetration == 0.,
                ExcMessage(
                  "'Deepest initial penetration' is set but " + treatment +
                  "; it acts with 'remove over time deep' only. Remove "
                  "one of them."));
    AssertThrow(initial_pressure == 0. ||
                  initial_penetration == InitialPenetration::ignore,
                ExcMessage(
                  "'Initial pressure' is set but " + treatment +
                  "; it acts with 'ignore' only. Remove one of them."));
    AssertThrow(removes || removal_time == 0.,
                ExcMessage("'Removal time' is set but " + treatment +
                           "; it acts with 'remove over time' and 'remove over "
                           "time deep' only. Remove one of them."));
    AssertThrow(modulus >= 0. && std::isfinite(modulus),
                ExcMessage("'Stiffness' is " + std::to_string(modulus) +
                           "; expected a positive pressure, or 0."));
    (void)explicit_length();
    friction.check();
    tie.check(has_ties(), kind == Kind::tiebreak);
    AssertThrow(kind != Kind::tied || !friction.is_on(),
                ExcMessage(
                  "'Friction coefficient' is set but 'Kind' is 'tied'; "
                  "a tied interface cannot slip. Remove one of them."));
    AssertThrow(!has_ties() ||
                  initial_penetration == InitialPenetration::stress,
                ExcMessage(treatment + " but 'Kind' is '" +
                           kinds[static_cast<unsigned int>(kind)] +
                           "'; ties are free of stress at the start. Remove "
                           "one of them."));
    AssertThrow(tool_normals == ToolNormals::check ||
                  kind == Kind::forming_surface_to_surface,
                ExcMessage("'Tool normals' is set but 'Kind' is not 'forming "
                           "surface to surface'. Remove one of them."));
    AssertThrow(kind != Kind::automatic_single_surface || primary_offset == 0.,
                ExcMessage("'Primary offset' is set but 'Kind' is 'automatic "
                           "single surface', which has no primary; use "
                           "'Secondary offset'."));
    AssertThrow(augmentation.is_on == (augmentation.tolerance > 0.),
                ExcMessage("'Augmentation' is '" +
                           std::string(augmentation.is_on ? "Uzawa" : "none") +
                           "' but 'Penetration tolerance' is " +
                           std::to_string(augmentation.tolerance) +
                           "; expected a positive tolerance with Uzawa, and "
                           "none without."));
    AssertThrow(!augmentation.is_on || !has_ties(),
                ExcMessage("'Augmentation' is 'Uzawa' but 'Kind' has ties; it "
                           "acts on contact pressures only."));
    AssertThrow(
      largest_penetration == 0. || characteristic_length != "shortest edge",
      ExcMessage("'Largest penetration' is set and 'Characteristic length' is "
                 "'shortest edge'; the first sets the characteristic length to "
                 "its double. Remove one of them."));
    AssertThrow(largest_share() <= 1.,
                ExcMessage("'Largest penetration' exceeds 'Characteristic "
                           "length'; expected at most as much."));
  }


  StiffnessSide
  ContactParameters::side() const
  {
    if (stiffness_side == "automatic")
      return (kind == Kind::forming_surface_to_surface) ?
               StiffnessSide::secondary :
               StiffnessSide::series;
    return (stiffness_side == "secondary") ? StiffnessSide::secondary :
                                             StiffnessSide::series;
  }


  unsigned int
  ContactParameters::n_sweeps() const
  {
    switch (kind)
      {
        case Kind::automatic_surface_to_surface:
        case Kind::tiebreak:
          return 2;
        case Kind::tied:
          return 0;
        default:
          return 1;
      }
  }


  double
  ContactParameters::explicit_length() const
  {
    if (characteristic_length == "shortest edge")
      return 0.;
    if (characteristic_length == "local")
      return 2. * largest_penetration;
    const bool   is_number = Patterns::Double(0.).match(characteristic_length);
    const double value =
      is_number ? Utilities::string_to_double(characteristic_length) : 0.;
    AssertThrow(value > 0.,
                ExcMessage("'Characteristic length' is '" +
                           characteristic_length +
                           "'; expected 'local', 'shortest edge' or a positive "
                           "length."));
    return value;
  }


  double
  ContactParameters::largest_share() const
  {
    const double length = explicit_length();
    return (largest_penetration > 0. && length > 0.) ?
             largest_penetration / length :
             0.5;
  }
} // namespace MortarContact
