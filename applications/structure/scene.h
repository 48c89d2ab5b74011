// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_scene_h
#define mortar_contact_structure_scene_h

#include "../geometry/mesh_parameters.h"
#include "dynamics.h"
#include "loads.h"
#include "material.h"
#include "newton.h"
#include "refinement.h"
#include "rigid_parameters.h"
#include "scene_source.h"

#include <mortar_contact/parameters/contact_parameters.h>

#include <map>
#include <string>
#include <vector>

namespace Structure
{
  /// One deformable body of a scene.
  struct BodyParameters
  {
    std::string name;
    bool        is_shell  = false;
    double      thickness = 0.; ///< Of a shell [m].
    /// Of the parts of a mesh file: name or material id, thickness [m].
    std::map<std::string, double> part_thickness;
    double             director_scale = 0.; ///< Of a shell [m]; 0: cell size.
    bool               is_turned      = false; ///< Top and bottom exchanged.
    MeshParameters     mesh;
    MaterialParameters material;
    unsigned int       degree          = 1;
    std::string        mean_dilatation = "automatic";
    std::string        body_force;
    /// Velocity at the start: formulas in x, y, z; empty: at rest.
    std::string initial_velocity;
  };

  /// Faces of a body that belong to a surface: "body", "body: boundary 1, 2",
  /// "body: material 3"; several joined by semicolons.
  struct PartSelection
  {
    std::string                  body;
    MortarContact::FaceSelection faces;
  };

  /// One contact interface of a scene.
  struct InterfaceParameters
  {
    std::string                      name;
    std::vector<PartSelection>       secondary, primary;
    MortarContact::ContactParameters contact;
  };

  /// Automatic step size.
  struct StepParameters
  {
    double              end_time = 1., first = 0.1, smallest = 0., largest = 0.;
    double              growth = 1.5, cut = 0.5;
    unsigned int        target_iterations = 6;
    unsigned int        max_steps         = 100000;
    std::vector<double> times_to_meet;
  };

  /// A point of a body whose displacement is recorded.
  struct ProbeParameters
  {
    std::string         name, body;
    std::vector<double> point;
  };

  /// What is written, and where.
  struct OutputParameters
  {
    std::string  directory        = "output";
    unsigned int every            = 1; ///< Steps between VTU files; 0: last.
    unsigned int checkpoint_every = 5; ///< Steps; 0: at the end only.
    bool         has_resolution   = false; ///< See ContactResolution.
    /// Of the surface of shells that is written [m]; negative: none.
    double                       surface_offset = -1.;
    std::vector<ProbeParameters> probes;
  };

  /// A complete scene.
  struct Scene
  {
    unsigned int                     dimension = 3;
    std::vector<BodyParameters>      bodies;
    std::vector<RigidParameters>     rigid_bodies;
    DynamicsParameters               dynamics;
    std::vector<BoundaryCondition>   conditions;
    std::vector<InterfaceParameters> interfaces;
    StepParameters                   steps;
    RefinementParameters             refinement;
    ValveParameters                  valve;
    NewtonParameters                 newton;
    LinearSolverParameters           linear;
    OutputParameters                 output;
  };

  /**
   * Read a scene of contact_scene: a first pass over the names of bodies,
   * conditions, interfaces and probes, a second, strict one over everything.
   *
   * @param used All entries as used, in the form of a parameter file.
   * @throw ExcMessage with file, line, entry, value found and values expected.
   */
  Scene
  read_scene(const SceneSource &source, std::string &used);

  /// The annotated defaults, with one of everything.
  std::string
  default_scene(const std::string &driver);

  /// Declare and read the parts that all drivers share: Steps, Solver, Output.
  void
  declare_run(ParameterHandler &prm);
  void
  read_run(ParameterHandler &prm, Scene &scene);

  /// Check names that refer to each other, and make file names absolute.
  void
  check_scene(Scene &scene);

  /// Parse "body: boundary 1, 2; other".
  std::vector<PartSelection>
  parse_parts(const std::string &text, const std::string &entry);
} // namespace Structure

#endif
