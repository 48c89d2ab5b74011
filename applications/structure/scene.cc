// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene.h"

#include "accuracy.h"
#include "numbers_of.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

namespace Structure
{
  namespace
  {
    std::string
    join(const std::vector<std::string> &names)
    {
      std::string result;
      for (const auto &name : names)
        result += (result.empty() ? "'" : ", '") + name + "'";
      return result.empty() ? "none" : result;
    }

    /// Run @p read in a subsection; its errors name the subsection.
    template <class Function>
    void
    in_section(ParameterHandler               &prm,
               const std::vector<std::string> &path,
               const Function                 &read)
    {
      for (const auto &section : path)
        prm.enter_subsection(section);
      try
        {
          read();
        }
      catch (const ExceptionBase &e)
        {
          std::ostringstream info;
          e.print_info(info);
          std::string where;
          for (const auto &section : path)
            where += section + "/";
          AssertThrow(false,
                      ExcMessage("In section '" +
                                 where.substr(0, where.size() - 1) +
                                 "': " + Utilities::trim(info.str())));
        }
      for (std::size_t i = 0; i < path.size(); ++i)
        prm.leave_subsection();
    }

    /// Names in a list entry, which must differ.
    std::vector<std::string>
    names_of(ParameterHandler &prm, const std::string &entry)
    {
      std::vector<std::string> names =
        Utilities::split_string_list(prm.get(entry));
      names.erase(std::remove(names.begin(), names.end(), ""), names.end());
      for (std::size_t i = 0; i < names.size(); ++i)
        AssertThrow(std::count(names.begin(), names.end(), names[i]) == 1,
                    ExcMessage("'" + entry + "' has '" + names[i] +
                               "' twice; expected different names."));
      return names;
    }

    /// The lists of names that decide which subsections there are.
    struct Names
    {
      std::vector<std::string> bodies, conditions, interfaces, probes, rigid;
    };

    void
    declare_names(ParameterHandler &prm)
    {
      prm.declare_entry("Driver",
                        "contact_scene",
                        Patterns::Anything(),
                        "The program that this file belongs to.");
      declare_accuracy(prm);
      prm.declare_entry("Dimension",
                        "3",
                        Patterns::Integer(2, 3),
                        "2: plane strain; 3.");
      const auto list =
        [&](const char *section, const char *entry, const char *help) {
          prm.enter_subsection(section);
          prm.declare_entry(entry, "", Patterns::Anything(), help);
          prm.leave_subsection();
        };
      list("Bodies",
           "Names",
           "Names of the bodies, separated by commas; one subsection each.");
      list("Boundary conditions",
           "Names",
           "Names of the conditions; one subsection each.");
      list("Contact",
           "Interfaces",
           "Names of the contact interfaces; one subsection each.");
      list("Rigid bodies",
           "Names",
           "Names of the rigid bodies; one subsection each.");
      list("Probes",
           "Names",
           "Names of points whose displacement is recorded; one subsection "
           "each.");
    }

    Names
    read_names(ParameterHandler &prm)
    {
      Names names;
      in_section(prm, {"Bodies"}, [&]() {
        names.bodies = names_of(prm, "Names");
        AssertThrow(!names.bodies.empty(),
                    ExcMessage("'Names' is empty; expected at least one "
                               "name."));
      });
      in_section(prm, {"Boundary conditions"}, [&]() {
        names.conditions = names_of(prm, "Names");
      });
      in_section(prm, {"Contact"}, [&]() {
        names.interfaces = names_of(prm, "Interfaces");
      });
      in_section(prm, {"Rigid bodies"}, [&]() {
        names.rigid = names_of(prm, "Names");
      });
      in_section(prm, {"Probes"}, [&]() {
        names.probes = names_of(prm, "Names");
      });
      return names;
    }

    void
    declare_body(ParameterHandler &prm)
    {
      prm.enter_subsection("Mesh");
      MeshParameters::declare(prm);
      prm.leave_subsection();
      prm.enter_subsection("Material");
      MaterialParameters::declare(prm);
      prm.leave_subsection();
      prm.declare_entry("Type",
                        "solid",
                        Patterns::Selection("solid|shell"),
                        "shell: the mesh is a surface in space; finite "
                        "rotations.");
      prm.declare_entry("Thickness",
                        "0.0",
                        Patterns::Double(0.),
                        "Of a shell [length]; 0: as the mesh file says (*SHELL "
                        "SECTION of an Abaqus file), or Thickness of parts.");
      prm.declare_entry(
        "Thickness of parts",
        "",
        Patterns::Map(
          Patterns::Anything(), Patterns::Double(1e-300), 0, 100000),
        "Of a shell from a file: names (or numbers) of the parts "
        "and their thickness [length], for example rim: 1.2, "
        "panel: 0.7. Parts are the sections or element sets of "
        "an Abaqus file, the physical surfaces of a gmsh file.");
      prm.declare_entry("Turn over",
                        "false",
                        Patterns::Bool(),
                        "Exchange top and bottom of a shell. The top of a box "
                        "is where x cross y of its mesh points.");
      prm.declare_entry("Director scale",
                        "0.0",
                        Patterns::Double(0.),
                        "Length that scales the second half of a shell's "
                        "unknowns, for the condition of the matrix [length]; "
                        "0: the mean size of the cells.");
      prm.declare_entry("Degree",
                        "1",
                        Patterns::Integer(1, 2),
                        "Of the displacements [-].");
      prm.declare_entry(
        "Mean dilatation",
        "automatic",
        Patterns::Selection("automatic|yes|no"),
        "One pressure per cell (Q1P0): no locking of nearly "
        "incompressible solids. automatic: for Mooney-Rivlin on "
        "hexahedra (quadrilaterals) of degree 1.");
      prm.declare_entry("Body force",
                        "",
                        Patterns::Anything(),
                        "Force per undeformed volume: formulas in x, y, z, t, "
                        "one per component, separated by semicolons.");
      prm.declare_entry("Initial velocity",
                        "",
                        Patterns::Anything(),
                        "Formulas in x, y, z, one per component, separated by "
                        "semicolons [length/time]; empty: at rest.");
    }

    void
    read_body(ParameterHandler &prm, BodyParameters &body)
    {
      in_section(prm, {"Mesh"}, [&]() { body.mesh.read(prm); });
      in_section(prm, {"Material"}, [&]() { body.material.read(prm); });
      body.is_shell       = prm.get("Type") == "shell";
      body.thickness      = prm.get_double("Thickness");
      body.is_turned      = prm.get_bool("Turn over");
      body.director_scale = prm.get_double("Director scale");
      for (const std::string &part :
           Utilities::split_string_list(prm.get("Thickness of parts")))
        {
          const std::size_t colon = part.rfind(':');
          body.part_thickness[Utilities::trim(part.substr(0, colon))] =
            Utilities::string_to_double(part.substr(colon + 1));
        }
      const bool has_parts = body.is_shell && body.mesh.type == "file";
      AssertThrow(body.part_thickness.empty() || has_parts,
                  ExcMessage("'Thickness of parts' is set: expected Type = "
                             "shell and 'Mesh/Type' = file."));
      AssertThrow(has_parts || body.is_shell == (body.thickness > 0.),
                  ExcMessage(body.is_shell ?
                               "'Type' is 'shell' but 'Thickness' is 0; "
                               "expected a positive number." :
                               "'Thickness' is set but 'Type' is 'solid'; "
                               "expected Type = shell."));
      body.degree           = prm.get_integer("Degree");
      body.mean_dilatation  = prm.get("Mean dilatation");
      body.body_force       = prm.get("Body force");
      body.initial_velocity = prm.get("Initial velocity");
      AssertThrow(body.mean_dilatation != "yes" ||
                    body.material.law == "Mooney-Rivlin",
                  ExcMessage("'Mean dilatation' is 'yes' but 'Material/Law' is "
                             "'" +
                             body.material.law +
                             "'; only Mooney-Rivlin has a volumetric part of "
                             "its own."));
    }

    void
    declare_condition(ParameterHandler &prm)
    {
      prm.declare_entry("Body", "", Patterns::Anything(), "Name of the body.");
      prm.declare_entry("Boundary ids",
                        "0",
                        Patterns::List(Patterns::Integer(0), 1),
                        "Ids of the faces [-].");
      prm.declare_entry(
        "Type",
        "displacement",
        Patterns::Selection("displacement|symmetry|traction|pressure|moment"),
        "displacement: x, y, z as formulas or free. symmetry: none along the "
        "normal. traction: force per undeformed area. pressure: pushes along "
        "the deformed normal. moment: about the axes x, y, z, on the edges of "
        "a shell, per undeformed length.");
      for (const char *component : {"x", "y", "z"})
        prm.declare_entry(
          component,
          "free",
          Patterns::Anything(),
          "Component as a formula in x, y, z, t and pi, or free "
          "[length, pressure or, of moments, force].");
      prm.declare_entry("Point",
                        "",
                        Patterns::List(Patterns::Double(), 0, 3),
                        "The condition holds at the node nearest to this place "
                        "[length] instead of on faces; a traction is a force "
                        "then.");
      prm.declare_entry("Where",
                        "",
                        Patterns::Anything(),
                        "The condition holds at all nodes where this formula "
                        "in x, y, z is not 0, instead of on faces; for example "
                        "abs(x) < 30 && z > 5.");
      prm.declare_entry("On surface",
                        "false",
                        Patterns::Bool(),
                        "Of a shell: the load acts on its surface instead of "
                        "on edges; pressure pushes on the top.");
      prm.declare_entry("Directors",
                        "free",
                        Patterns::Selection("free|fixed"),
                        "Of a shell: fixed with x, y, z makes a clamp, free a "
                        "hinge.");
      prm.declare_entry("Plane normal",
                        "",
                        Patterns::List(Patterns::Double(), 0, 3),
                        "Of the plane of symmetry of a shell [-].");
      prm.declare_entry("Pressure",
                        "free",
                        Patterns::Anything(),
                        "For Type = pressure: formula [pressure].");
    }

    void
    read_condition(ParameterHandler &prm, BoundaryCondition &c)
    {
      using Type = BoundaryCondition::Type;
      c.body     = prm.get("Body");
      for (const double id : numbers_of(prm.get("Boundary ids")))
        c.boundaries.insert(static_cast<types::boundary_id>(id));
      const std::string type = prm.get("Type");
      c.type                 = (type == "displacement") ? Type::displacement :
                               (type == "symmetry")     ? Type::symmetry :
                               (type == "traction")     ? Type::traction :
                               (type == "moment")       ? Type::moment :
                                                          Type::pressure;
      c.values               = {{prm.get("x"), prm.get("y"), prm.get("z")}};
      c.point                = numbers_of(prm.get("Point"));
      c.where                = prm.get("Where");
      c.on_surface           = prm.get_bool("On surface");
      c.fixes_directors      = prm.get("Directors") == "fixed";
      const std::vector<double> normal = numbers_of(prm.get("Plane normal"));
      for (unsigned int i = 0; i < normal.size(); ++i)
        c.plane_normal[i] = normal[i];
      if (c.plane_normal.norm() > 0.)
        c.plane_normal /= c.plane_normal.norm();
      AssertThrow(c.point.empty() || c.type == Type::displacement ||
                    c.type == Type::traction,
                  ExcMessage("'Point' is set but 'Type' is '" + type +
                             "'; expected displacement or traction."));
      AssertThrow(c.where.empty() ||
                    (c.type == Type::displacement && c.point.empty()),
                  ExcMessage("'Where' is set: expected Type = displacement, "
                             "and no 'Point'."));
      AssertThrow(!c.on_surface ||
                    (c.point.empty() &&
                     (c.type == Type::traction || c.type == Type::pressure)),
                  ExcMessage("'On surface' is 'true': expected Type = traction "
                             "or pressure, and no 'Point'."));
      AssertThrow(!c.fixes_directors || c.type == Type::displacement,
                  ExcMessage("'Directors' are 'fixed' but 'Type' is '" + type +
                             "'; expected displacement."));
      const bool any =
        c.values[0] != "free" || c.values[1] != "free" || c.values[2] != "free";
      const std::string pressure = prm.get("Pressure");
      if (c.type == Type::pressure)
        {
          AssertThrow(pressure != "free",
                      ExcMessage("'Type' is 'pressure' but 'Pressure' is "
                                 "'free'; expected a formula."));
          c.values = {{pressure, "free", "free"}};
        }
      else
        AssertThrow(pressure == "free",
                    ExcMessage("'Pressure' is set but 'Type' is '" + type +
                               "'; expected Type = pressure."));
      AssertThrow(any ? (c.type != Type::symmetry && c.type != Type::pressure) :
                        (c.type == Type::symmetry || c.type == Type::pressure),
                  ExcMessage("'Type' is '" + type + "' but 'x', 'y', 'z' are " +
                             (any ? "set; it has no components." :
                                    "all 'free'; expected a formula for at "
                                    "least one.")));
    }

    void
    declare_interface(ParameterHandler &prm)
    {
      for (const char *side : {"Secondary", "Primary"})
        prm.declare_entry(side,
                          "",
                          Patterns::Anything(),
                          std::string(side) +
                            " surface: body, 'body: boundary 1, 2' or 'body: "
                            "material 3', of shells also 'body: top', bottom "
                            "or edges; several separated by semicolons. The "
                            "secondary (SURFA, slave) carries the integration "
                            "points.");
      MortarContact::ContactParameters::declare(prm);
    }

    void
    read_interface(ParameterHandler &prm, InterfaceParameters &i)
    {
      i.secondary = parse_parts(prm.get("Secondary"), "Secondary");
      i.primary   = parse_parts(prm.get("Primary"), "Primary");
      i.contact.read(prm);
    }

    void
    declare_everything(ParameterHandler &prm, const Names &names)
    {
      declare_names(prm);
      const auto each = [&](const char                     *section,
                            const std::vector<std::string> &list,
                            const auto                     &declare) {
        prm.enter_subsection(section);
        for (const auto &name : list)
          {
            prm.enter_subsection(name);
            declare(prm);
            prm.leave_subsection();
          }
        prm.leave_subsection();
      };
      each("Bodies", names.bodies, declare_body);
      each("Rigid bodies", names.rigid, RigidParameters::declare);
      each("Boundary conditions", names.conditions, declare_condition);
      each("Contact", names.interfaces, declare_interface);
      each("Probes", names.probes, [](ParameterHandler &p) {
        p.declare_entry("Body", "", Patterns::Anything(), "Name of the body.");
        p.declare_entry("Point",
                        "0, 0, 0",
                        Patterns::List(Patterns::Double(), 2, 3),
                        "Undeformed place; the nearest node counts [length].");
      });
      declare_run(prm);
    }
  } // namespace


  std::vector<PartSelection>
  parse_parts(const std::string &text, const std::string &entry)
  {
    std::vector<PartSelection> parts;
    for (const std::string &part : Utilities::split_string_list(text, ';'))
      {
        PartSelection     selection;
        const std::size_t colon = part.find(':');
        selection.body          = Utilities::trim(part.substr(0, colon));
        if (colon != std::string::npos)
          {
            const std::string rest  = Utilities::trim(part.substr(colon + 1));
            const std::size_t space = rest.find(' ');
            const std::string what  = rest.substr(0, space);
            bool              ok = (what == "boundary" || what == "material") &&
                      space != std::string::npos;
            if (rest == "top" || rest == "bottom" || rest == "edges")
              {
                ok                     = true;
                selection.faces.top    = rest == "top";
                selection.faces.bottom = rest == "bottom";
                selection.faces.edges  = rest == "edges";
              }
            else if (ok)
              for (const std::string &id :
                   Utilities::split_string_list(rest.substr(space + 1)))
                {
                  ok = ok && Patterns::Integer(0).match(id);
                  if (ok && what == "boundary")
                    selection.faces.boundaries.insert(std::stoul(id));
                  else if (ok)
                    selection.faces.materials.insert(std::stoul(id));
                }
            AssertThrow(ok,
                        ExcMessage(
                          "'" + entry + "' is '" + text +
                          "'; expected 'body', 'body: boundary 1, 2', "
                          "'body: material 3' or, of a shell, 'body: top', "
                          "'body: bottom', 'body: edges', several separated "
                          "by semicolons."));
          }
        parts.push_back(selection);
      }
    return parts;
  }


  void
  declare_run(ParameterHandler &prm)
  {
    prm.enter_subsection("Steps");
    prm.declare_entry("End time", "1.0", Patterns::Double(1e-300), "[time]");
    prm.declare_entry("First step", "0.1", Patterns::Double(1e-300), "[time]");
    prm.declare_entry("Smallest step",
                      "0.0",
                      Patterns::Double(0.),
                      "Cut back no further [time]; 0: first step / 1000.");
    prm.declare_entry("Largest step",
                      "0.0",
                      Patterns::Double(0.),
                      "[time]; 0: the first step, no growth beyond it.");
    prm.declare_entry("Growth",
                      "1.5",
                      Patterns::Double(1.),
                      "Factor on the step after an easy one [-].");
    prm.declare_entry("Cut back",
                      "0.5",
                      Patterns::Double(0.01, 0.99),
                      "Factor on a step that failed [-].");
    prm.declare_entry("Target iterations",
                      "6",
                      Patterns::Integer(1),
                      "A step with at most so many Newton iterations was easy "
                      "[-].");
    prm.declare_entry("Maximum steps",
                      "100000",
                      Patterns::Integer(1),
                      "Accepted steps [-].");
    prm.declare_entry("Times to meet",
                      "",
                      Patterns::List(Patterns::Double(0.)),
                      "Times at which a step ends [time].");
    prm.leave_subsection();
    prm.enter_subsection("Dynamics");
    DynamicsParameters::declare(prm);
    prm.leave_subsection();
    prm.enter_subsection("Refinement");
    RefinementParameters::declare(prm);
    prm.leave_subsection();
    prm.enter_subsection("Solver");
    prm.enter_subsection("Newton");
    NewtonParameters::declare(prm);
    prm.leave_subsection();
    prm.enter_subsection("Linear");
    LinearSolverParameters::declare(prm);
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Output");
    prm.declare_entry("Directory", "output", Patterns::Anything(), "");
    prm.declare_entry("Every",
                      "1",
                      Patterns::Integer(0),
                      "Steps between VTU files [-]; 0: the last step only.");
    prm.declare_entry("Checkpoint every",
                      "5",
                      Patterns::Integer(0),
                      "Steps between checkpoints [-]; 0: at the end only.");
    prm.declare_entry("Contact resolution",
                      "false",
                      Patterns::Bool(),
                      "Print each step, and write to history.csv, how well "
                      "contact is resolved: gaps, their jumps between facets, "
                      "distance and crossings of shells' mid-surfaces, change "
                      "in the last iteration.");
    prm.declare_entry("Surface offset",
                      "-1",
                      Patterns::Double(),
                      "Write the outer surfaces of shells, moved out by this, "
                      "to closed STL files beside the VTU files [length]; "
                      "negative: none.");
    prm.leave_subsection();
  }


  void
  read_run(ParameterHandler &prm, Scene &scene)
  {
    in_section(prm, {"Steps"}, [&]() {
      StepParameters &s   = scene.steps;
      s.end_time          = prm.get_double("End time");
      s.first             = prm.get_double("First step");
      s.smallest          = prm.get_double("Smallest step");
      s.largest           = prm.get_double("Largest step");
      s.growth            = prm.get_double("Growth");
      s.cut               = prm.get_double("Cut back");
      s.target_iterations = prm.get_integer("Target iterations");
      s.max_steps         = prm.get_integer("Maximum steps");
      s.times_to_meet     = numbers_of(prm.get("Times to meet"));
      if (s.smallest == 0.)
        s.smallest = s.first / 1000.;
      if (s.largest == 0.)
        s.largest = s.first;
      AssertThrow(s.smallest <= s.first && s.first <= s.largest,
                  ExcMessage("'First step' is " + std::to_string(s.first) +
                             "; expected a value between 'Smallest step' (" +
                             std::to_string(s.smallest) +
                             ") and 'Largest step' (" +
                             std::to_string(s.largest) + ")."));
    });
    in_section(prm, {"Dynamics"}, [&]() { scene.dynamics.read(prm); });
    in_section(prm, {"Refinement"}, [&]() { scene.refinement.read(prm); });
    in_section(prm, {"Solver", "Newton"}, [&]() { scene.newton.read(prm); });
    in_section(prm, {"Solver", "Linear"}, [&]() { scene.linear.read(prm); });
    in_section(prm, {"Output"}, [&]() {
      scene.output.directory        = prm.get("Directory");
      scene.output.every            = prm.get_integer("Every");
      scene.output.checkpoint_every = prm.get_integer("Checkpoint every");
      scene.output.has_resolution   = prm.get_bool("Contact resolution");
      scene.output.surface_offset   = prm.get_double("Surface offset");
    });
  }


  Scene
  read_scene(const SceneSource &source, std::string &used)
  {
    Names       names;
    std::string accuracy;
    {
      ParameterHandler prm;
      declare_names(prm);
      parse(prm, source, true);
      names    = read_names(prm);
      accuracy = prm.get("Accuracy");
    }

    ParameterHandler prm;
    declare_everything(prm, names);
    std::vector<std::vector<std::string>> interfaces;
    for (const auto &name : names.interfaces)
      interfaces.push_back({"Contact", name});
    set_accuracy(prm, accuracy, interfaces);
    parse(prm, source, false);

    Scene scene;
    scene.dimension = prm.get_integer("Dimension");
    for (const auto &name : names.bodies)
      {
        scene.bodies.emplace_back();
        scene.bodies.back().name = name;
        in_section(prm, {"Bodies", name}, [&]() {
          read_body(prm, scene.bodies.back());
        });
      }
    for (const auto &name : names.rigid)
      {
        scene.rigid_bodies.emplace_back();
        scene.rigid_bodies.back().name = name;
        in_section(prm, {"Rigid bodies", name}, [&]() {
          scene.rigid_bodies.back().read(prm);
        });
      }
    for (const auto &name : names.conditions)
      {
        scene.conditions.emplace_back();
        scene.conditions.back().name = name;
        in_section(prm, {"Boundary conditions", name}, [&]() {
          read_condition(prm, scene.conditions.back());
        });
      }
    for (const auto &name : names.interfaces)
      {
        scene.interfaces.emplace_back();
        scene.interfaces.back().name = name;
        in_section(prm, {"Contact", name}, [&]() {
          read_interface(prm, scene.interfaces.back());
        });
      }
    for (const auto &name : names.probes)
      in_section(prm, {"Probes", name}, [&]() {
        scene.output.probes.push_back(
          {name, prm.get("Body"), numbers_of(prm.get("Point"))});
      });
    read_run(prm, scene);

    // mesh files are named from where the parameter file is
    const std::size_t slash = source.file.find_last_of('/');
    if (slash != std::string::npos)
      for (BodyParameters &body : scene.bodies)
        if (!body.mesh.file.empty() && body.mesh.file[0] != '/')
          body.mesh.file = source.file.substr(0, slash + 1) + body.mesh.file;
    if (slash != std::string::npos)
      for (RigidParameters &body : scene.rigid_bodies)
        if (!body.file.empty() && body.file[0] != '/')
          body.file = source.file.substr(0, slash + 1) + body.file;

    check_scene(scene);
    used = used_entries(prm, source);
    return scene;
  }


  void
  check_scene(Scene &scene)
  {
    std::vector<std::string> names;
    for (const auto &b : scene.bodies)
      names.push_back(b.name);
    for (const auto &r : scene.rigid_bodies)
      AssertThrow(std::find(names.begin(), names.end(), r.name) == names.end(),
                  ExcMessage(
                    "'Rigid bodies/Names' and 'Bodies/Names' both have "
                    "'" +
                    r.name + "'; expected different names."));
    const auto check = [&](const std::string &name, const std::string &entry) {
      AssertThrow(std::find(names.begin(), names.end(), name) != names.end(),
                  ExcMessage("'" + entry + "' names the body '" + name +
                             "'; there are " + join(names) + "."));
    };
    for (const auto &c : scene.conditions)
      {
        check(c.body, "Boundary conditions/" + c.name + "/Body");
        AssertThrow(scene.dimension == 3 || c.values[2] == "free",
                    ExcMessage("'Boundary conditions/" + c.name +
                               "/z' is set but 'Dimension' is 2."));
      }
    const std::vector<std::string> deformable = names;
    for (const auto &r : scene.rigid_bodies)
      names.push_back(r.name);
    for (const auto &i : scene.interfaces)
      {
        const bool is_single =
          i.contact.kind ==
          MortarContact::ContactParameters::Kind::automatic_single_surface;
        AssertThrow(i.primary.empty() == is_single,
                    ExcMessage(
                      "'Contact/" + i.name + "/Primary' is " +
                      (is_single ?
                         "set but 'Kind' is 'automatic single surface'; name "
                         "all parts as Secondary, and no Primary." :
                         "empty; expected at least one body.")));
        AssertThrow(!i.secondary.empty(),
                    ExcMessage("'Contact/" + i.name +
                               "/Secondary' is empty; expected at least one "
                               "body."));
      }
    for (const auto &i : scene.interfaces)
      for (const auto &s : i.secondary)
        for (const auto &p : i.primary)
          {
            const auto &a = s.faces, &b = p.faces;
            AssertThrow(s.body != p.body || a.boundaries != b.boundaries ||
                          a.materials != b.materials || a.top != b.top ||
                          a.bottom != b.bottom || a.edges != b.edges,
                        ExcMessage("'Contact/" + i.name +
                                   "': 'Secondary' and 'Primary' both have "
                                   "the same surface of '" +
                                   s.body +
                                   "'; expected two, or 'Kind = automatic "
                                   "single surface' for a surface that meets "
                                   "itself."));
          }
    for (const auto &i : scene.interfaces)
      for (const auto &[parts, side] :
           {std::make_pair(&i.secondary, "Secondary"),
            std::make_pair(&i.primary, "Primary")})
        for (const auto &part : *parts)
          {
            check(part.body, "Contact/" + i.name + "/" + side);
            const bool is_shell =
              std::any_of(scene.bodies.begin(),
                          scene.bodies.end(),
                          [&](const BodyParameters &b) {
                            return b.name == part.body && b.is_shell;
                          });
            AssertThrow(is_shell || (part.faces.top && part.faces.bottom &&
                                     part.faces.edges),
                        ExcMessage("'Contact/" + i.name + "/" + side +
                                   "' asks for top, bottom or edges of '" +
                                   part.body + "', which is not a shell."));
          }
    names = deformable;
    for (const auto &p : scene.output.probes)
      {
        check(p.body, "Probes/" + p.name + "/Body");
        AssertThrow(p.point.size() == scene.dimension,
                    ExcMessage("'Probes/" + p.name + "/Point' has " +
                               std::to_string(p.point.size()) +
                               " numbers; expected " +
                               std::to_string(scene.dimension) + "."));
      }
    for (const auto &a : scene.conditions)
      for (const auto &b : scene.conditions)
        {
          using Type = BoundaryCondition::Type;
          if (&a >= &b || a.body != b.body || !a.point.empty() ||
              !b.point.empty() || !a.where.empty() || !b.where.empty() ||
              a.type != Type::displacement || b.type != Type::displacement)
            continue;
          for (const auto id : a.boundaries)
            for (unsigned int k = 0; k < 3; ++k)
              AssertThrow(b.boundaries.count(id) == 0 ||
                            a.values[k] == "free" || b.values[k] == "free",
                          ExcMessage("'Boundary conditions/" + a.name +
                                     "' and '" + b.name + "' both prescribe '" +
                                     std::string(1, "xyz"[k]) +
                                     "' on boundary id " + std::to_string(id) +
                                     " of '" + a.body +
                                     "'. Remove one of them."));
        }
    for (const auto &b : scene.bodies)
      {
        const std::string &law = b.material.law;
        AssertThrow(!b.is_shell ||
                      ((law == "automatic" || law == "St Venant-Kirchhoff" ||
                        law == "neo-Hookean") &&
                       b.degree == 1 && b.mean_dilatation != "yes"),
                    ExcMessage("'Bodies/" + b.name +
                               "' is a shell: expected Degree = 1, no mean "
                               "dilatation, and 'Material/Law' automatic, St "
                               "Venant-Kirchhoff or neo-Hookean, not '" +
                               law + "'."));
        AssertThrow(b.material.hardening.yield_stress == 0. ||
                      (b.is_shell && law != "neo-Hookean"),
                    ExcMessage("'Bodies/" + b.name +
                               "/Material/Yield stress' is set: expected Type "
                               "= shell, and not the neo-Hookean law."));
        AssertThrow(b.material.hardening.yield_stress == 0. ||
                      scene.dynamics.stiffness_damping == 0.,
                    ExcMessage("'Bodies/" + b.name +
                               "/Material/Yield stress' is set: expected no "
                               "'Dynamics/Stiffness damping', which would "
                               "depend on what has yielded."));
        AssertThrow(!scene.dynamics.is_on || b.material.density > 0.,
                    ExcMessage("'Dynamics/Type' is 'dynamic' but 'Bodies/" +
                               b.name +
                               "/Material/Density' is 0; expected a positive "
                               "density."));
        AssertThrow(scene.dynamics.is_on || b.initial_velocity.empty(),
                    ExcMessage(
                      "'Bodies/" + b.name +
                      "/Initial velocity' is set but 'Dynamics/Type' is "
                      "'static'. Remove one of them."));
      }
    for (const auto &c : scene.conditions)
      for (const auto &b : scene.bodies)
        if (b.name == c.body)
          {
            const std::string where = "'Boundary conditions/" + c.name + "/";
            AssertThrow(b.is_shell || !(c.on_surface || c.fixes_directors ||
                                        c.plane_normal.norm() > 0.),
                        ExcMessage(where +
                                   "' sets 'On surface', 'Directors' or 'Plane "
                                   "normal', but '" +
                                   b.name + "' is a solid; expected a shell."));
            AssertThrow(b.is_shell || c.type != BoundaryCondition::Type::moment,
                        ExcMessage(where + "Type' is 'moment', but '" + b.name +
                                   "' is a solid; expected a shell."));
            AssertThrow(!b.is_shell ||
                          c.type != BoundaryCondition::Type::symmetry ||
                          c.plane_normal.norm() > 0.,
                        ExcMessage(where +
                                   "Plane normal' is empty; expected "
                                   "the normal of the plane of symmetry "
                                   "of the shell '" +
                                   b.name + "'."));
            AssertThrow(!b.is_shell ||
                          c.type != BoundaryCondition::Type::pressure ||
                          c.on_surface,
                        ExcMessage(where +
                                   "On surface' is 'false'; expected "
                                   "true for a pressure on the shell '" +
                                   b.name + "'."));
            AssertThrow(c.point.empty() || c.point.size() == scene.dimension,
                        ExcMessage(where + "Point' has " +
                                   std::to_string(c.point.size()) +
                                   " numbers; expected " +
                                   std::to_string(scene.dimension) + "."));
          }
    // treatments that end at a time: a step ends there
    for (const auto &i : scene.interfaces)
      if (i.contact.removal_time > 0.)
        scene.steps.times_to_meet.push_back(i.contact.removal_time);
  }


  std::string
  default_scene(const std::string &driver)
  {
    ParameterHandler prm;
    declare_everything(
      prm, {{"body"}, {"condition"}, {"interface"}, {"probe"}, {"rigid body"}});
    prm.set("Driver", driver);
    // a scene that runs: a block is pressed on a plane
    using Path     = std::vector<std::string>;
    const auto set = [&](const Path        &path,
                         const std::string &entry,
                         const std::string &value) {
      for (const std::string &section : path)
        prm.enter_subsection(section);
      prm.set(entry, value);
      for (std::size_t i = 0; i < path.size(); ++i)
        prm.leave_subsection();
    };
    set({"Bodies"}, "Names", "body");
    set({"Bodies", "body", "Material"}, "Young's modulus", "1000");
    set({"Rigid bodies"}, "Names", "rigid body");
    set({"Boundary conditions"}, "Names", "condition");
    const Path condition{"Boundary conditions", "condition"};
    set(condition, "Body", "body");
    set(condition, "Boundary ids", "5");
    set(condition, "x", "0");
    set(condition, "y", "0");
    set(condition, "z", "-0.01*t");
    set({"Contact"}, "Interfaces", "interface");
    set({"Contact", "interface"}, "Secondary", "body: boundary 4");
    set({"Contact", "interface"}, "Primary", "rigid body");
    set({"Probes"}, "Names", "probe");
    set({"Probes", "probe"}, "Body", "body");
    std::ostringstream out;
    prm.print_parameters(out, ParameterHandler::PRM);
    return out.str();
  }
} // namespace Structure
