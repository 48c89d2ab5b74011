// SPDX-License-Identifier: LGPL-2.1-or-later

// The quasi-static placement of a dummy on a car's hood: the dummy's motion is
// prescribed (down, pressed, slid along), the force of the contact is the
// result.

#include "geometry/ellipsoid.h"
#include "geometry/hood.h"
#include "structure/driver.h"
#include "structure/numbers_of.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace
{
  using namespace Structure;

  /// Of the stops below the front corners, over the hood's length.
  constexpr double stop_radius = 1. / 60., stop_clearance = 1. / 1200.;

  void
  declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300), not_negative(0.);
    const Patterns::List   two(Patterns::Double(), 2, 2);
    prm.enter_subsection("Hood");
    Hood::declare(prm);
    prm.enter_subsection("Material");
    MaterialParameters::declare(prm);
    prm.set("Young's modulus", 210e3);
    prm.set("Poisson's ratio", 0.3);
    prm.set("Density", 7.85e-9);
    prm.leave_subsection();
    prm.declare_entry("Support size",
                      "90",
                      positive,
                      "Edge of the patches of the frame that hinges and latch "
                      "hold [length].");
    prm.declare_entry("Bump stops",
                      "true",
                      Patterns::Bool(),
                      "Two rigid cylinders below the frame's front corners, "
                      "1/1200 of the length away from it.");
    prm.leave_subsection();
    prm.enter_subsection("Glue");
    MortarContact::ContactParameters::declare(prm);
    prm.set("Kind", "tied");
    // ties have no edge to resolve
    prm.set("Degree", "2");
    // of the flanges, not of the bowls beside them
    prm.set("Tie tolerance", 1.);
    prm.leave_subsection();
    prm.enter_subsection("Dummy");
    prm.declare_entry("Type",
                      "rigid",
                      Patterns::Selection("rigid|foam"),
                      "rigid: a surface of facets. foam: elastic layers over "
                      "rigid cores.");
    prm.declare_entry(
      "Parts",
      "0, 0, 110, 180, 120; 300, 0, 230, 170, 120",
      Patterns::Anything(),
      "Ellipsoids: x, y of the middle and semi-axes along x, y, "
      "z of each, separated by semicolons. Each lies on the "
      "undeformed hood at the start [length].");
    prm.declare_entry("Position",
                      "560, 120",
                      two,
                      "x, y that are added to those of the parts [length].");
    prm.declare_entry("Facet size",
                      "15",
                      positive,
                      "Of the dummy's surface [length].");
    prm.declare_entry("Smooth",
                      "no",
                      Patterns::Selection("yes|no"),
                      "Of a rigid dummy: quadratic patches instead of plane "
                      "facets.");
    prm.declare_entry("Foam thickness", "20", positive, "[length]");
    prm.declare_entry("Foam layers",
                      "2",
                      Patterns::Integer(1),
                      "Cells across [-].");
    prm.declare_entry("Foam modulus", "1", positive, "Young's [pressure].");
    prm.declare_entry("Foam density",
                      "5e-11",
                      positive,
                      "[mass/volume]; 50 kg/m^3 in t/mm^3.");
    prm.declare_entry("Foam Poisson's ratio",
                      "0.2",
                      Patterns::Double(0., 0.49),
                      "");
    prm.leave_subsection();
    prm.enter_subsection("Motion");
    prm.declare_entry("Clearance",
                      "2",
                      not_negative,
                      "Between dummy and hood at the start [length].");
    prm.declare_entry("Press",
                      "3",
                      not_negative,
                      "Down from where it touches, until time 1 [length].");
    prm.declare_entry("Slide",
                      "0, 100",
                      two,
                      "Along x and y, from time 1 to 2; the height follows the "
                      "undeformed hood below the first part [length].");
    prm.leave_subsection();
    prm.enter_subsection("Contact");
    MortarContact::ContactParameters::declare(prm);
    prm.leave_subsection();
    declare_run(prm);
    // thin sheets snap: strong damping of velocities carries the solution over
    // limit points, where there is no static path, and does little elsewhere
    prm.enter_subsection("Dynamics");
    prm.set("Type", "dynamic");
    prm.set("Spectral radius", 0.);
    prm.set("Mass damping", 1000.);
    prm.leave_subsection();
    prm.enter_subsection("Steps");
    prm.set("End time", 2.);
    prm.set("First step", 0.05);
    prm.set("Cut back", 0.3);
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    prm.enter_subsection("Newton");
    prm.set("Predictor", "linear");
    prm.set("Maximum iterations", "12");
    // the force tolerance decides
    prm.set("Displacement tolerance", 1e-4);
    prm.leave_subsection();
    prm.leave_subsection();
  }

  /// The parts of the dummy, each at its own height above the hood.
  std::vector<Ellipsoid>
  read_parts(ParameterHandler &prm, const Hood &hood, const double clearance)
  {
    const std::vector<double> position = numbers_of(prm.get("Position"));
    std::vector<Ellipsoid>    parts;
    for (const std::string &part :
         Utilities::split_string_list(prm.get("Parts"), ';'))
      {
        std::vector<double> n;
        bool                is_ok = true;
        for (const std::string &value : Utilities::split_string_list(part))
          {
            is_ok = is_ok && Patterns::Double().match(value);
            if (is_ok)
              n.push_back(Utilities::string_to_double(value));
          }
        AssertThrow(is_ok && n.size() == 5 && std::min({n[2], n[3], n[4]}) > 0.,
                    ExcMessage("'Dummy/Parts' has '" + part +
                               "'; expected x, y and three positive "
                               "semi-axes."));
        Ellipsoid e;
        e.centre[0] = position[0] + n[0];
        e.centre[1] = position[1] + n[1];
        for (unsigned int i = 0; i < 3; ++i)
          e.axes[i] = n[2 + i];

        // lift it until it clears the panel's top everywhere
        const unsigned int samples = 200;
        double             lift    = std::numeric_limits<double>::lowest();
        for (unsigned int i = 0; i <= samples; ++i)
          for (unsigned int j = 0; j <= samples; ++j)
            {
              const double r = 2. * i / samples - 1., s = 2. * j / samples - 1.;
              const double below = 1. - r * r - s * s;
              if (below < 0.)
                continue;
              const double x = e.centre[0] + r * e.axes[0];
              const double y = e.centre[1] + s * e.axes[1];
              if (x < 0. || x > hood.length || std::abs(y) > 0.5 * hood.width)
                continue;
              lift = std::max(lift,
                              hood.height(x, y) + 0.5 * hood.panel_thickness +
                                e.axes[2] * std::sqrt(below));
            }
        AssertThrow(lift > std::numeric_limits<double>::lowest(),
                    ExcMessage("'Dummy/Parts' has '" + part +
                               "' at 'Position' " + prm.get("Position") +
                               "; expected a place over the hood."));
        e.centre[2] = lift + clearance;
        parts.push_back(e);
      }
    AssertThrow(!parts.empty(),
                ExcMessage("'Dummy/Parts' is empty; expected at least one."));
    return parts;
  }

  Scene
  read_placement(ParameterHandler &prm)
  {
    Scene scene;
    using Type           = BoundaryCondition::Type;
    const auto condition = [&](const std::string                &name,
                               const std::string                &body,
                               const std::array<std::string, 3> &values) {
      BoundaryCondition c;
      c.name   = name;
      c.body   = body;
      c.type   = Type::displacement;
      c.values = values;
      scene.conditions.push_back(c);
    };

    // Step 1: the hood and what holds it.
    const auto         hood = std::make_shared<Hood>();
    MaterialParameters steel;
    prm.enter_subsection("Hood");
    hood->read(prm);
    const double support   = prm.get_double("Support size");
    const bool   has_stops = prm.get_bool("Bump stops");
    prm.enter_subsection("Material");
    steel.read(prm);
    prm.leave_subsection();
    prm.leave_subsection();
    for (const bool is_panel : {true, false})
      {
        BodyParameters sheet;
        sheet.name     = is_panel ? "panel" : "frame";
        sheet.is_shell = true;
        sheet.thickness =
          is_panel ? hood->panel_thickness : hood->frame_thickness;
        sheet.material        = steel;
        sheet.mesh.make_shell = [hood, is_panel](Triangulation<2, 3> &mesh) {
          is_panel ? hood->make_panel(mesh) : hood->make_frame(mesh);
        };
        scene.bodies.push_back(sheet);
      }
    const std::string half  = text_of(0.5 * support);
    const auto        patch = [&](const std::string &name,
                           const double       x,
                           const std::string &y) {
      condition(name, "frame", {{"0", "0", "0"}});
      scene.conditions.back().where = "abs(x - " + text_of(x) + ") <= " + half +
                                      " && abs(" + y + ") <= " + half;
    };
    const double side = 0.4 * hood->width;
    patch("hinges", hood->length - 0.5 * support, "abs(y) - " + text_of(side));
    patch("latch", 0.5 * support, "y");

    InterfaceParameters glue;
    glue.name                   = "glue";
    glue.secondary              = {{"panel", {}}};
    glue.primary                = {{"frame", {}}};
    glue.secondary[0].faces.top = glue.secondary[0].faces.edges = false;
    glue.primary[0].faces.bottom = glue.primary[0].faces.edges = false;
    prm.enter_subsection("Glue");
    glue.contact.read(prm);
    prm.leave_subsection();
    scene.interfaces.push_back(glue);

    // Step 2: the dummy.
    prm.enter_subsection("Motion");
    const double              clearance = prm.get_double("Clearance");
    const double              press     = prm.get_double("Press");
    const std::vector<double> slide     = numbers_of(prm.get("Slide"));
    prm.leave_subsection();
    prm.enter_subsection("Dummy");
    const std::vector<Ellipsoid> parts    = read_parts(prm, *hood, clearance);
    const bool                   is_rigid = prm.get("Type") == "rigid";
    const double                 size     = prm.get_double("Facet size");
    const double                 layer    = prm.get_double("Foam thickness");
    const unsigned int           n_layers = prm.get_integer("Foam layers");
    const bool                   smooth   = prm.get("Smooth") == "yes";
    MaterialParameters           foam;
    foam.youngs_modulus = prm.get_double("Foam modulus");
    foam.density        = prm.get_double("Foam density");
    foam.poissons_ratio = prm.get_double("Foam Poisson's ratio");
    prm.leave_subsection();

    const Tensor<1, 3> &start = parts[0].centre;
    const double        down  = clearance + press;
    const double up = hood->height(start[0] + slide[0], start[1] + slide[1]) -
                      hood->height(start[0], start[1]);
    const std::string                sliding = "*max(0, t - 1)";
    const std::array<std::string, 3> motion  = {
       {text_of(slide[0]) + sliding,
        text_of(slide[1]) + sliding,
        "-" + text_of(down) + "*min(t, 1) + " + text_of(up) + sliding}};

    InterfaceParameters contact;
    contact.name                      = "dummy";
    contact.secondary                 = {{"panel", {}}};
    contact.secondary[0].faces.bottom = contact.secondary[0].faces.edges =
      false;
    if (is_rigid)
      {
        RigidParameters dummy;
        dummy.name            = "dummy";
        dummy.type            = "mesh";
        dummy.smooth          = smooth;
        dummy.translation     = motion;
        dummy.rotation_centre = {start[0], start[1], start[2]};
        make_surface(parts, size, dummy.vertices, dummy.facets);
        scene.rigid_bodies.push_back(dummy);
        contact.primary = {{"dummy", {}}};
      }
    else
      for (unsigned int i = 0; i < parts.size(); ++i)
        {
          const Ellipsoid &e = parts[i];
          AssertThrow(layer < std::min({e.axes[0], e.axes[1], e.axes[2]}),
                      ExcMessage("'Dummy/Foam thickness' is " + text_of(layer) +
                                 "; expected less than the semi-axes of the "
                                 "parts."));
          BodyParameters body;
          body.name     = "foam " + std::to_string(i + 1);
          body.material = foam;
          body.mesh.make_solid =
            [e, layer, n_layers, size](Triangulation<3> &mesh) {
              make_lower_layer(e, layer, n_layers, size, mesh);
            };
          scene.bodies.push_back(body);
          condition("core " + std::to_string(i + 1), body.name, motion);
          scene.conditions.back().boundaries = {1};
          contact.primary.push_back(
            {body.name, MortarContact::boundary_ids({3})});
        }
    prm.enter_subsection("Contact");
    contact.contact.read(prm);
    prm.leave_subsection();
    scene.interfaces.push_back(contact);

    // Step 3: stops that the frame's front corners come to lie on.
    for (const double sign : {-1., 1.})
      {
        if (!has_stops)
          break;
        const double    x = 0.5 * support, y = sign * side;
        RigidParameters stop;
        stop.name   = sign < 0. ? "left stop" : "right stop";
        stop.type   = "cylinder";
        stop.radius = stop_radius * hood->length;
        stop.length = 2. * stop.radius;
        // its top along the frame
        const double h = 1e-3 * hood->length;
        Tensor<1, 3> top, up;
        top[0] = x;
        top[1] = y;
        top[2] = hood->height(x, y);
        up[0]  = -(hood->height(x + h, y) - hood->height(x - h, y)) / (2. * h);
        up[1]  = -(hood->height(x, y + h) - hood->height(x, y - h)) / (2. * h);
        up[2]  = 1.;
        up /= up.norm();
        top -= (0.5 * hood->panel_thickness + hood->frame_thickness +
                stop_clearance * hood->length + 0.5 * stop.length) *
               up;
        stop.axis     = {up[0], up[1], up[2]};
        stop.position = {top[0], top[1], top[2]};
        scene.rigid_bodies.push_back(stop);
        InterfaceParameters on_stop;
        on_stop.name                     = stop.name;
        on_stop.secondary                = {{"frame", {}}};
        on_stop.secondary[0].faces.top   = false;
        on_stop.secondary[0].faces.edges = false;
        on_stop.primary                  = {{stop.name, {}}};
        on_stop.contact                  = contact.contact;
        scene.interfaces.push_back(on_stop);
      }

    read_run(prm, scene);
    scene.steps.times_to_meet.push_back(1.);
    check_scene(scene);
    return scene;
  }
} // namespace


int
main(int argc, char **argv)
{
  return Structure::run_driver(
    Structure::make_driver(
      "dummy_on_hood",
      "A dummy is pressed on a car's hood and slid along it.",
      declare,
      read_placement),
    argc,
    argv);
}
