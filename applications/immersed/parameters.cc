// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parameters.h"

#include "../structure/numbers_of.h"

#include <deal.II/base/utilities.h>

namespace Immersed
{
  namespace
  {
    std::vector<Point<2>>
    points_of(const std::string &entry, const std::string &text)
    {
      std::vector<Point<2>> points;
      for (const std::string &one : Utilities::split_string_list(text, ';'))
        {
          const std::vector<double> x = Structure::numbers_of(one);
          AssertThrow(x.size() == 2,
                      ExcMessage("'Leaflets/" + entry + "' is '" + text +
                                 "'; expected points x, y separated by "
                                 "semicolons, for example 2, 0; 2, 1.61."));
          points.emplace_back(x[0], x[1]);
        }
      return points;
    }
  } // namespace


  void
  Parameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Channel");
    prm.declare_entry("Length", "8", Patterns::Double(1e-300), "[length]");
    prm.declare_entry("Height", "1.61", Patterns::Double(1e-300), "[length]");
    prm.declare_entry("Cells",
                      "40, 8",
                      Patterns::List(Patterns::Integer(1), 2, 2),
                      "Along and across.");
    prm.declare_entry("Refinements",
                      "2",
                      Patterns::Integer(0, 8),
                      "Of the cells that leaflets cut, and of those around "
                      "them: halved so many times.");
    prm.declare_entry("Refine every",
                      "10",
                      Patterns::Integer(0),
                      "Steps after which the mesh follows the leaflets; 0: "
                      "never.");
    prm.leave_subsection();

    prm.enter_subsection("Fluid");
    prm.declare_entry("Density",
                      "100",
                      Patterns::Double(0.),
                      "[mass/length^3]");
    prm.declare_entry("Viscosity",
                      "10",
                      Patterns::Double(1e-300),
                      "Dynamic [pressure time].");
    prm.declare_entry("Grad-div",
                      "100",
                      Patterns::Double(0.),
                      "Keeps volume within cells that leaflets cut [pressure "
                      "time]: about the pressure jump times the size of a cell "
                      "over the velocity. Too little leaks.");
    prm.declare_entry("Coupling penalty",
                      "0",
                      Patterns::Double(0.),
                      "beta: force per area of a leaflet over the slip of the "
                      "fluid [pressure time/length]; the leaflets leak by the "
                      "pressure jump over it. 0: from viscosity, density, cell "
                      "and step.");
    prm.declare_entry("Inflow",
                      "velocity",
                      Patterns::Selection("velocity|pressure"),
                      "What is prescribed at the left end.");
    prm.declare_entry("Inflow value",
                      "5*(sin(2*pi*t)+1.1)*y*(1.61-y)",
                      Patterns::Anything(),
                      "A formula in y, t and pi: velocity along the channel, "
                      "or pressure (of t) of a fluid at rest before the "
                      "channel.");
    prm.declare_entry("Outlet pressure",
                      "0",
                      Patterns::Anything(),
                      "A formula in t and pi.");
    prm.leave_subsection();

    prm.enter_subsection("Leaflets");
    prm.declare_entry("Roots",
                      "2, 0; 2, 1.61",
                      Patterns::Anything(),
                      "Clamped ends of the leaflets, x, y separated by "
                      "semicolons.");
    prm.declare_entry("Tips",
                      "2, 0.7; 2, 0.91",
                      Patterns::Anything(),
                      "Free ends when undeformed.");
    prm.declare_entry("Cells", "40", Patterns::Integer(1), "Of each leaflet.");
    prm.declare_entry("Thickness",
                      "0.0212",
                      Patterns::Double(1e-300),
                      "[length]");
    prm.declare_entry("Young's modulus",
                      "5.6e7",
                      Patterns::Double(1e-300),
                      "[pressure]");
    prm.declare_entry("Poisson's ratio",
                      "0.4",
                      Patterns::Double(0., 0.499),
                      "[-]");
    prm.declare_entry("Density",
                      "100",
                      Patterns::Double(0.),
                      "[mass/length^3]");
    prm.declare_entry("Rigid",
                      "false",
                      Patterns::Bool(),
                      "They do not move: walls.");
    prm.leave_subsection();

    prm.enter_subsection("Contact");
    prm.declare_entry("Leaflets touch",
                      "true",
                      Patterns::Bool(),
                      "Each other and themselves; false: no contact.");
    MortarContact::ContactParameters::declare(prm);
    prm.set("Kind", std::string("automatic single surface"));
    prm.leave_subsection();

    prm.enter_subsection("Steps");
    prm.declare_entry("End time", "3", Patterns::Double(1e-300), "[time]");
    prm.declare_entry("First step",
                      "0.01",
                      Patterns::Double(1e-300),
                      "Halved where Newton's method fails, then doubled again "
                      "[time].");
    prm.declare_entry("Smallest step",
                      "0",
                      Patterns::Double(0.),
                      "0: a thousandth of the first [time].");
    prm.leave_subsection();

    prm.enter_subsection("Solver");
    prm.declare_entry("Force tolerance",
                      "1e-7",
                      Patterns::Double(1e-14, 1e-1),
                      "Residual over the largest of the run so far [-].");
    prm.declare_entry("Iterations",
                      "15",
                      Patterns::Integer(2),
                      "After so many the step is halved.");
    prm.leave_subsection();

    prm.enter_subsection("Output");
    prm.declare_entry("Directory",
                      "output/immersed_leaflets",
                      Patterns::Anything(),
                      "");
    prm.declare_entry("Every",
                      "10",
                      Patterns::Integer(0),
                      "Steps between pictures; 0: the last only.");
    prm.declare_entry("Checkpoint every",
                      "50",
                      Patterns::Integer(0),
                      "Steps; 0: at a stop only.");
    prm.leave_subsection();
  }


  void
  Parameters::read(ParameterHandler &prm)
  {
    prm.enter_subsection("Channel");
    length                            = prm.get_double("Length");
    height                            = prm.get_double("Height");
    const std::vector<double> n_cells = Structure::numbers_of(prm.get("Cells"));
    n_x                               = static_cast<unsigned int>(n_cells[0]);
    n_y                               = static_cast<unsigned int>(n_cells[1]);
    n_refinements                     = prm.get_integer("Refinements");
    refine_every                      = prm.get_integer("Refine every");
    prm.leave_subsection();

    prm.enter_subsection("Fluid");
    fluid.density   = prm.get_double("Density");
    fluid.viscosity = prm.get_double("Viscosity");
    fluid.grad_div  = prm.get_double("Grad-div");
    penalty         = prm.get_double("Coupling penalty");
    has_velocity    = prm.get("Inflow") == "velocity";
    inflow          = prm.get("Inflow value");
    outlet          = prm.get("Outlet pressure");
    prm.leave_subsection();

    prm.enter_subsection("Leaflets");
    const std::vector<Point<2>> roots = points_of("Roots", prm.get("Roots"));
    const std::vector<Point<2>> ends  = points_of("Tips", prm.get("Tips"));
    AssertThrow(!roots.empty(),
                ExcMessage(
                  "'Leaflets/Roots' is empty; expected the clamped end "
                  "of each leaflet, for example 2, 0; 2, 1.61."));
    AssertThrow(
      roots.size() == ends.size(),
      ExcMessage("'Leaflets/Roots' has " + std::to_string(roots.size()) +
                 " points, 'Leaflets/Tips' has " + std::to_string(ends.size()) +
                 "; expected one of each for each leaflet."));
    leaflets.clear();
    for (unsigned int l = 0; l < roots.size(); ++l)
      {
        for (const Point<2> &x : {roots[l], ends[l]})
          AssertThrow(x[0] >= 0. && x[0] <= length && x[1] >= 0. &&
                        x[1] <= height,
                      ExcMessage("Leaflet " + std::to_string(l) + " has (" +
                                 Structure::number(x[0]) + ", " +
                                 Structure::number(x[1]) +
                                 "); expected a point of the channel, 0 to " +
                                 Structure::number(length) + " by 0 to " +
                                 Structure::number(height) + "."));
        AssertThrow(roots[l].distance(ends[l]) > 0.,
                    ExcMessage("Leaflet " + std::to_string(l) +
                               " has no length: 'Roots' and 'Tips' agree."));
        leaflets.push_back({roots[l],
                            ends[l],
                            static_cast<unsigned int>(prm.get_integer("Cells")),
                            prm.get_bool("Rigid")});
      }
    material.thickness      = prm.get_double("Thickness");
    material.youngs_modulus = prm.get_double("Young's modulus");
    material.poissons_ratio = prm.get_double("Poisson's ratio");
    material.density        = prm.get_double("Density");
    prm.leave_subsection();

    prm.enter_subsection("Contact");
    has_contact = prm.get_bool("Leaflets touch");
    contact.read(prm);
    prm.leave_subsection();

    prm.enter_subsection("Steps");
    end_time      = prm.get_double("End time");
    first_step    = prm.get_double("First step");
    smallest_step = prm.get_double("Smallest step");
    if (smallest_step == 0.)
      smallest_step = 1e-3 * first_step;
    AssertThrow(smallest_step <= first_step,
                ExcMessage("'Steps/Smallest step' is " +
                           Structure::number(smallest_step) +
                           "; expected no more than 'First step', " +
                           Structure::number(first_step) + "."));
    prm.leave_subsection();

    prm.enter_subsection("Solver");
    tolerance    = prm.get_double("Force tolerance");
    n_iterations = prm.get_integer("Iterations");
    prm.leave_subsection();

    prm.enter_subsection("Output");
    directory    = prm.get("Directory");
    output_every = prm.get_integer("Every");
    save_every   = prm.get_integer("Checkpoint every");
    prm.leave_subsection();
  }
} // namespace Immersed
