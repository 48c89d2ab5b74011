// SPDX-License-Identifier: LGPL-2.1-or-later

// The fit of a rubber ring with a bulge in a steel seat: the meshes overlap
// deeply at the start, the overlap is removed over time (IGNORE = 4), then the
// shaft inside the ring may be moved.

#include "structure/driver.h"
#include "structure/material.h"
#include "structure/numbers_of.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>


namespace
{
  using namespace Structure;

  void
  declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300);
    const Patterns::List   three(Patterns::Integer(1), 3, 3);
    prm.enter_subsection("Rubber");
    prm.declare_entry("Inner radius",
                      "12.0",
                      positive,
                      "Bonded to the shaft [length].");
    prm.declare_entry("Outer radius",
                      "19.5",
                      positive,
                      "At the ends of the ring [length].");
    prm.declare_entry("Bulge",
                      "2.0",
                      Patterns::Double(0.),
                      "Height of the bulge in the middle, cos^2 along the axis "
                      "[length].");
    prm.declare_entry("Length", "20.0", positive, "[length]");
    prm.declare_entry("Cells",
                      "16, 7, 20",
                      three,
                      "Around, across, along [-].");
    prm.declare_entry("Hardness",
                      "60",
                      Patterns::Double(20., 95.),
                      "Shore A; gives Young's modulus in MPa [-].");
    prm.declare_entry("Young's modulus",
                      "0.0",
                      Patterns::Double(0.),
                      "[pressure]; 0: of the hardness, in MPa.");
    prm.declare_entry("Poisson's ratio",
                      "0.49",
                      Patterns::Double(0., 0.49999),
                      "");
    prm.leave_subsection();
    prm.enter_subsection("Seat");
    prm.declare_entry("Radius", "20.0", positive, "Of the bore [length].");
    prm.declare_entry("Wall", "8.0", positive, "Thickness [length].");
    prm.declare_entry("Length",
                      "24.0",
                      positive,
                      "[length]; centred on the ring.");
    prm.declare_entry("Cells",
                      "14, 3, 18",
                      three,
                      "Around, across, along [-].");
    prm.declare_entry("Young's modulus", "210e3", positive, "[pressure]");
    prm.declare_entry("Poisson's ratio", "0.3", Patterns::Double(0., 0.49), "");
    prm.leave_subsection();
    prm.enter_subsection("Fit");
    prm.declare_entry("Angle",
                      "90",
                      Patterns::Double(1., 360.),
                      "Sector that is modelled, with symmetry planes; 360: the "
                      "whole ring [degree].");
    prm.declare_entry("Removal time",
                      "1.0",
                      positive,
                      "Until the overlap is removed [time].");
    prm.declare_entry("Shaft displacement",
                      "0.0",
                      Patterns::Double(),
                      "Of the shaft along the axis after the fit, over another "
                      "removal time; end time is doubled [length].");
    prm.leave_subsection();
    prm.enter_subsection("Contact");
    MortarContact::ContactParameters::declare(prm);
    prm.leave_subsection();
    declare_run(prm);
    prm.enter_subsection("Contact");
    prm.set("Initial penetration", "remove over time deep");
    prm.leave_subsection();
    // the rubber relaxes steadily: without, each step starts from an overlap
    // that only the contact knows of
    prm.enter_subsection("Solver");
    prm.enter_subsection("Newton");
    prm.set("Predictor", "linear");
    prm.leave_subsection();
    prm.leave_subsection();
  }

  std::vector<unsigned int>
  cells(ParameterHandler &prm)
  {
    std::vector<unsigned int> result;
    for (const double n : Utilities::string_to_double(
           Utilities::split_string_list(prm.get("Cells"))))
      result.push_back(static_cast<unsigned int>(n));
    return result;
  }

  /// The two rings and what holds them, as a scene.
  Scene
  read_fit(ParameterHandler &prm)
  {
    Scene          scene;
    BodyParameters rubber, seat;
    rubber.name = "rubber";
    seat.name   = "seat";

    prm.enter_subsection("Rubber");
    const double inner             = prm.get_double("Inner radius");
    const double outer             = prm.get_double("Outer radius");
    const double bulge             = prm.get_double("Bulge");
    const double length            = prm.get_double("Length");
    rubber.mesh.cells              = cells(prm);
    rubber.material.law            = "Mooney-Rivlin";
    rubber.material.youngs_modulus = prm.get_double("Young's modulus");
    if (rubber.material.youngs_modulus == 0.)
      rubber.material.youngs_modulus =
        youngs_modulus_of_rubber(prm.get_double("Hardness"));
    rubber.material.poissons_ratio = prm.get_double("Poisson's ratio");
    prm.leave_subsection();

    prm.enter_subsection("Seat");
    const double bore            = prm.get_double("Radius");
    const double wall            = prm.get_double("Wall");
    const double seat_length     = prm.get_double("Length");
    seat.mesh.cells              = cells(prm);
    seat.material.youngs_modulus = prm.get_double("Young's modulus");
    seat.material.poissons_ratio = prm.get_double("Poisson's ratio");
    prm.leave_subsection();

    prm.enter_subsection("Fit");
    const double angle        = prm.get_double("Angle");
    const double removal_time = prm.get_double("Removal time");
    const double shaft        = prm.get_double("Shaft displacement");
    prm.leave_subsection();

    AssertThrow(outer > inner,
                ExcMessage("'Rubber/Outer radius' is " + text_of(outer) +
                           "; expected more than 'Rubber/Inner radius', " +
                           text_of(inner) + "."));
    AssertThrow(bore > inner,
                ExcMessage("'Seat/Radius' is " + text_of(bore) +
                           "; expected more than 'Rubber/Inner radius', " +
                           text_of(inner) + "."));

    for (BodyParameters *body : {&rubber, &seat})
      {
        body->mesh.type       = "revolution";
        body->mesh.last_angle = angle;
      }
    rubber.mesh.length       = length;
    rubber.mesh.inner_radius = text_of(inner);
    rubber.mesh.outer_radius = text_of(outer) + "+" + text_of(bulge) +
                               "*cos(pi*(z/" + text_of(length) + "-0.5))^2";
    seat.mesh.length       = seat_length;
    seat.mesh.inner_radius = text_of(bore);
    seat.mesh.outer_radius = text_of(bore + wall);
    seat.mesh.move         = {0., 0., 0.5 * (length - seat_length)};
    scene.bodies           = {rubber, seat};

    using Type           = BoundaryCondition::Type;
    const auto condition = [&](const std::string                  &name,
                               const std::string                  &body,
                               const std::set<types::boundary_id> &ids,
                               const Type                          type) {
      BoundaryCondition c;
      c.name       = name;
      c.body       = body;
      c.boundaries = ids;
      c.type       = type;
      return c;
    };
    BoundaryCondition bond =
      condition("shaft", "rubber", {2}, Type::displacement);
    bond.values = {{"0",
                    "0",
                    text_of(shaft) + "*max(0,t-" + text_of(removal_time) +
                      ")/" + text_of(removal_time)}};
    BoundaryCondition housing =
      condition("housing", "seat", {3}, Type::displacement);
    housing.values   = {{"0", "0", "0"}};
    scene.conditions = {bond, housing};
    if (angle < 360.)
      {
        scene.conditions.push_back(condition(
          "symmetry of the rubber", "rubber", {0, 1}, Type::symmetry));
        scene.conditions.push_back(
          condition("symmetry of the seat", "seat", {0, 1}, Type::symmetry));
      }

    InterfaceParameters fit;
    fit.name      = "fit";
    fit.secondary = {{"rubber", MortarContact::boundary_ids({3})}};
    fit.primary   = {{"seat", MortarContact::boundary_ids({2})}};
    // The fit decides when the overlap is gone, and how deep it is.
    prm.enter_subsection("Contact");
    const bool removes = prm.get("Initial penetration").rfind("remove", 0) == 0;
    if (removes && prm.get_double("Removal time") == 0.)
      prm.set("Removal time", removal_time);
    if (prm.get("Initial penetration") == "remove over time deep" &&
        prm.get_double("Deepest initial penetration") == 0.)
      {
        // flat facets of the seat stand out of its circle
        const double half_facet =
          angle / 360. * numbers::PI / std::max(1u, seat.mesh.cells[0]);
        prm.set("Deepest initial penetration",
                1.1 * std::max(outer + bulge - bore * std::cos(half_facet),
                               1e-3 * bore));
      }
    fit.contact.read(prm);
    prm.leave_subsection();
    scene.interfaces = {fit};

    read_run(prm, scene);
    scene.steps.end_time = (shaft != 0. ? 2. : 1.) * removal_time;
    check_scene(scene);
    return scene;
  }
} // namespace


int
main(int argc, char **argv)
{
  return Structure::run_driver(
    Structure::make_driver(
      "rubber_fit",
      "A rubber ring relaxes out of a deep initial overlap with its steel seat.",
      declare,
      read_fit),
    argc,
    argv);
}
