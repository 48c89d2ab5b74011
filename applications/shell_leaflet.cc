// SPDX-License-Identifier: LGPL-2.1-or-later

// The leaflets of a heart valve open and close in a lumped fluid, or under a
// prescribed difference of pressure; they meet each other, their free edges and
// the wall of the sinuses in contact.

#include "geometry/leaflet.h"
#include "structure/driver.h"

#include <deal.II/base/patterns.h>

#include <cmath>
#include <memory>

namespace
{
  using namespace Structure;

  void
  declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Leaflets");
    prm.declare_entry("Number",
                      "three",
                      Patterns::Selection("three|one"),
                      "one: a leaflet between two rigid planes through the "
                      "axis, which stand for its neighbours.");
    prm.declare_entry(
      "Mesh file",
      "",
      Patterns::Anything(),
      "All leaflets in a file of quadrilaterals or triangles "
      "in place of the sizes below (but thickness, and with a "
      "fluid the radius, the tube's): the axis is z, edges with "
      "boundary id 0 are attached, those with 1 free, each "
      "leaflet has a material id of its own, normals point to "
      "the aorta.");
    Leaflet::declare(prm);
    prm.declare_entry("Attachment",
                      "hinged",
                      Patterns::Selection("hinged|clamped"),
                      "Of the leaflets to the tube.");
    prm.enter_subsection("Material");
    MaterialParameters::declare(prm);
    // CGS units, dyn/cm^2 and g/cm^3
    prm.set("Young's modulus", 1e7);
    prm.set("Poisson's ratio", 0.45);
    prm.set("Density", 1.);
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Sinuses");
    SinusWall::declare(prm);
    prm.leave_subsection();
    prm.enter_subsection("Load");
    prm.declare_entry(
      "Type",
      "fluid",
      Patterns::Selection("fluid|pressure"),
      "fluid: an incompressible one around the leaflets, driven "
      "by the pressure of the ventricle and solved together with "
      "them, see 'Fluid'. pressure: prescribed.");
    prm.declare_entry("Pressure",
                      "if(t < 0.02, 1e6*t, if(t < 0.1, 2e4, "
                      "if(t < 0.13, 2e4 - 4e6*(t - 0.1), -1e5)))",
                      Patterns::Anything(),
                      "Of the ventricle less that of the aorta, a formula of "
                      "t: positive opens the valve [pressure].");
    prm.leave_subsection();
    prm.enter_subsection("Fluid");
    FluidParameters::declare(prm);
    prm.leave_subsection();
    prm.enter_subsection("Contact");
    MortarContact::ContactParameters::declare(prm);
    // where three edges meet, little area carries much: 10 is released there
    prm.set("Stiffness scale", 100.);
    prm.leave_subsection();
    declare_run(prm);
    prm.enter_subsection("Dynamics");
    prm.set("Type", "dynamic");
    prm.set("Spectral radius", 0.);
    // drag of the blood beside the leaflets, which a lumped fluid does not
    // know: without, leaflets flutter (under a prescribed pressure they fly)
    prm.set("Mass damping", 2000.);
    prm.leave_subsection();
    prm.enter_subsection("Steps");
    prm.set("End time", 0.29);
    prm.set("First step", 1e-3);
    prm.set("Largest step", 4e-3);
    prm.leave_subsection();
    prm.enter_subsection("Output");
    prm.set("Contact resolution", true);
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    prm.enter_subsection("Newton");
    // the force tolerance decides
    prm.set("Displacement tolerance", 1e-4);
    prm.leave_subsection();
    prm.leave_subsection();
  }

  Scene
  read_valve(ParameterHandler &prm)
  {
    Scene scene;

    // Step 1: the leaflets.
    const auto     leaflet = std::make_shared<Leaflet>();
    BodyParameters body;
    body.name     = "leaflets";
    body.is_shell = true;
    prm.enter_subsection("Leaflets");
    leaflet->read(prm);
    const bool is_one = prm.get("Number") == "one";
    body.thickness    = leaflet->thickness;
    body.mesh.file    = prm.get("Mesh file");
    if (body.mesh.file.empty())
      body.mesh.make_shell = [leaflet, is_one](Triangulation<2, 3> &mesh) {
        leaflet->make(is_one ? 1 : 3, mesh);
      };
    else
      body.mesh.type = "file";
    prm.enter_subsection("Material");
    body.material.read(prm);
    prm.leave_subsection();

    BoundaryCondition attached;
    attached.name            = "attachment";
    attached.body            = body.name;
    attached.boundaries      = {Leaflet::attachment};
    attached.type            = BoundaryCondition::Type::displacement;
    attached.values          = {{"0", "0", "0"}};
    attached.fixes_directors = prm.get("Attachment") == "clamped";
    prm.leave_subsection();
    scene.bodies.push_back(body);
    scene.conditions.push_back(attached);

    prm.enter_subsection("Load");
    const bool has_fluid = prm.get("Type") == "fluid";
    if (!has_fluid)
      {
        BoundaryCondition pressure;
        pressure.name       = "pressure";
        pressure.body       = body.name;
        pressure.type       = BoundaryCondition::Type::pressure;
        pressure.on_surface = true;
        // on the top, towards the aorta, it would close
        pressure.values[0] = "-(" + prm.get("Pressure") + ")";
        scene.conditions.push_back(pressure);
      }
    prm.leave_subsection();
    prm.enter_subsection("Fluid");
    if (has_fluid)
      {
        ValveParameters &valve = scene.valve;
        valve.is_on            = true;
        valve.body             = body.name;
        valve.free_edge        = Leaflet::free_edge;
        valve.tube_area    = numbers::PI * leaflet->radius * leaflet->radius;
        valve.multiplicity = is_one ? 3. : 1.;
        valve.fluid.read(prm);
        if (valve.fluid.closed_area == 0.)
          valve.fluid.closed_area = 3. * leaflet->radius * leaflet->thickness;
      }
    prm.leave_subsection();

    // Step 2: what they touch.
    InterfaceParameters contact;
    prm.enter_subsection("Contact");
    contact.contact.read(prm);
    AssertThrow(contact.contact.kind == MortarContact::ContactParameters().kind,
                ExcMessage("'Contact/Kind' is '" + prm.get("Kind") +
                           "'; expected the default: leaflets are a single "
                           "surface, planes and wall are tools."));
    prm.leave_subsection();
    contact.secondary = {{body.name, {}}};
    if (is_one)
      for (const double sign : {-1., 1.})
        {
          RigidParameters plane;
          plane.name = sign < 0. ? "right" : "left";
          plane.type = "plane";
          plane.axis = {std::sqrt(0.75), -0.5 * sign, 0.};
          scene.rigid_bodies.push_back(plane);
          contact.name    = plane.name;
          contact.primary = {{plane.name, {}}};
          scene.interfaces.push_back(contact);
        }
    else
      {
        contact.name = "leaflets";
        contact.contact.kind =
          MortarContact::ContactParameters::Kind::automatic_single_surface;
        scene.interfaces.push_back(contact);
      }
    prm.enter_subsection("Sinuses");
    if (prm.get("Wall") == "rigid")
      {
        SinusWall wall;
        wall.read(prm);
        RigidParameters rigid;
        rigid.name = "wall";
        rigid.type = "mesh";
        // the attachment is in the wall; what touches is all beside it
        wall.make(leaflet->radius + leaflet->thickness,
                  rigid.vertices,
                  rigid.facets);
        scene.rigid_bodies.push_back(rigid);
        InterfaceParameters on_wall;
        on_wall.name                      = "wall";
        on_wall.secondary                 = {{body.name, {}}};
        on_wall.secondary[0].faces.bottom = false;
        on_wall.primary                   = {{"wall", {}}};
        on_wall.contact                   = contact.contact;
        on_wall.contact.kind = MortarContact::ContactParameters().kind;
        scene.interfaces.push_back(on_wall);
      }
    prm.leave_subsection();
    read_run(prm, scene);
    AssertThrow(!has_fluid || scene.dynamics.is_on,
                ExcMessage("'Load/Type' is 'fluid' but 'Dynamics/Type' is "
                           "'static'; expected 'dynamic', or 'pressure'."));
    check_scene(scene);
    return scene;
  }
} // namespace


int
main(int argc, char **argv)
{
  return Structure::run_driver(
    Structure::make_driver(
      "shell_leaflet",
      "The leaflets of a heart valve open and close under pressure.",
      declare,
      read_valve),
    argc,
    argv);
}
