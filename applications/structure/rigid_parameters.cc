// SPDX-License-Identifier: LGPL-2.1-or-later
#include "rigid_parameters.h"

#include "../geometry/surface_reader.h"
#include "../geometry/thicken.h"
#include "expression.h"
#include "numbers_of.h"

#include <mortar_contact/geometry/smooth_facets.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Structure
{
  using namespace MortarContact;

  namespace
  {
    /// Formulas are differentiated over this share of the scene.
    constexpr double formula_step = 1e-4;

    template <int dim>
    Tensor<1, dim>
    vector_of(const std::vector<double> &values, const std::string &entry)
    {
      Tensor<1, dim> v;
      if (values.empty())
        return v;
      AssertThrow(values.size() == dim,
                  ExcMessage(
                    "'" + entry + "' has " + std::to_string(values.size()) +
                    " numbers; expected " + std::to_string(dim) + "."));
      for (unsigned int i = 0; i < dim; ++i)
        v[i] = values[i];
      return v;
    }

    /// The rotation that takes the last axis to @p axis.
    Tensor<2, 2>
    rotation_to(const Tensor<1, 2> &axis)
    {
      Tensor<1, 3> angle;
      angle[2] = std::atan2(-axis[0], axis[1]);
      return rotation_by<2>(angle);
    }

    Tensor<2, 3>
    rotation_to(const Tensor<1, 3> &axis)
    {
      Tensor<1, 3> z;
      z[2]                   = 1.;
      const Tensor<1, 3> a   = axis / axis.norm();
      Tensor<1, 3>       w   = cross_product_3d(z, a);
      const double       sin = w.norm();
      if (sin > 0.)
        w *= std::atan2(sin, a[2]) / sin;
      else if (a[2] < 0.)
        w[0] = numbers::PI;
      return rotation_by<3>(w);
    }
  } // namespace


  void
  RigidParameters::declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300), any;
    const Patterns::List   list(Patterns::Double(), 0, 3);
    prm.declare_entry(
      "Type",
      "ball",
      Patterns::Selection(
        "ball|cylinder|cone|box|torus|plane|ellipsoid|formula|mesh"),
      "Exact smooth surfaces (primary only), about the origin and the last "
      "axis: ball, cylinder (endless for Length 0), cone (apex at the origin, "
      "opens to negative), torus, plane (the body is below), box and ellipsoid "
      "(Sizes), formula; or a mesh of facets.");
    prm.declare_entry("Radius",
                      "1.0",
                      positive,
                      "Of ball, cylinder, torus [length].");
    prm.declare_entry("Tube radius", "0.5", positive, "Of the torus [length].");
    prm.declare_entry("Length",
                      "0.0",
                      Patterns::Double(0.),
                      "Of the cylinder [length].");
    prm.declare_entry("Half angle",
                      "45.0",
                      Patterns::Double(1., 89.),
                      "Of the cone [degrees].");
    prm.declare_entry("Sizes",
                      "",
                      list,
                      "Half widths of the box, semi-axes of the ellipsoid "
                      "[length].");
    prm.declare_entry("Formula",
                      "",
                      Patterns::Anything(),
                      "In x, y, z, t, negative inside, in the body's own "
                      "coordinates; of the size of a distance.");
    prm.declare_entry("File",
                      "",
                      Patterns::Anything(),
                      "Surface mesh: STL, gmsh .msh, Abaqus .inp, .vtk; from "
                      "where the parameter file is.");
    prm.declare_entry("Scale",
                      "1.0",
                      positive,
                      "Of the mesh's coordinates [-].");
    prm.declare_entry(
      "Thickness",
      "0.0",
      Patterns::Double(0.),
      "Of a sheet, of which the mesh is the middle surface: "
      "both sides and its edges are surfaces at half of it (as "
      "rigid shells in automatic contact) [length]; 0: the mesh "
      "is the outer surface (as in forming contact).");
    prm.declare_entry("Smooth",
                      "no",
                      Patterns::Selection("yes|no"),
                      "Replace the facets by quadratic patches across their "
                      "vertex normals (Nagata): no ripple of the force where a "
                      "coarse round tool slides. Primary only.");
    prm.declare_entry("Crease angle",
                      "40.0",
                      Patterns::Double(1., 179.),
                      "Facets that meet at a larger angle keep their edge "
                      "[degrees].");
    prm.declare_entry("Position", "", list, "Of the body's origin [length].");
    prm.declare_entry("Axis",
                      "",
                      list,
                      "Direction of the body's last axis; empty: the last "
                      "coordinate axis.");
    for (const char *component : {"x", "y", "z"})
      prm.declare_entry(std::string("Move ") + component,
                        "0",
                        Patterns::Anything(),
                        "Translation, a formula in t [length].");
    prm.declare_entry("Rotation axis",
                      "",
                      list,
                      "Of the motion (3d); empty: the last coordinate axis.");
    prm.declare_entry("Rotation angle",
                      "0",
                      Patterns::Anything(),
                      "A formula in t [rad].");
    prm.declare_entry(
      "Rotation centre",
      "",
      list,
      "Moments are taken about it, too; it moves with the body; "
      "empty: Position [length].");
    prm.declare_entry(
      "Free motions",
      "",
      Patterns::List(Patterns::Selection("x|y|z|rotation x|rotation y|rotation "
                                         "z|rotation"),
                     0,
                     6),
      "Motions that forces decide, and contact: x, y, z, rotation x, rotation "
      "y, rotation z (2d: x, y, rotation). The others follow the formulas "
      "above.");
    for (const char *component : {"x", "y", "z"})
      {
        prm.declare_entry(std::string("Force ") + component,
                          "0",
                          Patterns::Anything(),
                          "On a free motion, a formula in t [force].");
        prm.declare_entry(std::string("Moment ") + component,
                          "0",
                          Patterns::Anything(),
                          "On a free rotation, a formula in t [force length].");
      }
  }


  void
  RigidParameters::read(ParameterHandler &prm)
  {
    type          = prm.get("Type");
    radius        = prm.get_double("Radius");
    tube_radius   = prm.get_double("Tube radius");
    length        = prm.get_double("Length");
    half_angle    = prm.get_double("Half angle");
    sizes         = numbers_of(prm.get("Sizes"));
    formula       = prm.get("Formula");
    file          = prm.get("File");
    scale         = prm.get_double("Scale");
    thickness     = prm.get_double("Thickness");
    smooth        = prm.get("Smooth") == "yes";
    crease_angle  = prm.get_double("Crease angle");
    position      = numbers_of(prm.get("Position"));
    axis          = numbers_of(prm.get("Axis"));
    translation   = {{prm.get("Move x"), prm.get("Move y"), prm.get("Move z")}};
    rotation_axis = numbers_of(prm.get("Rotation axis"));
    rotation_angle  = prm.get("Rotation angle");
    rotation_centre = numbers_of(prm.get("Rotation centre"));
    free_motions    = Utilities::split_string_list(prm.get("Free motions"));
    for (unsigned int i = 0; i < 3; ++i)
      {
        const std::string component(1, "xyz"[i]);
        force[i]           = prm.get("Force " + component);
        moment[i]          = prm.get("Moment " + component);
        const auto is_free = [&](const std::string &motion) {
          return std::find(free_motions.begin(), free_motions.end(), motion) !=
                 free_motions.end();
        };
        AssertThrow(force[i] == "0" || is_free(component),
                    ExcMessage("'Force " + component +
                               "' is set but 'Free motions' has no '" +
                               component + "'."));
        AssertThrow(moment[i] == "0" || is_free("rotation " + component) ||
                      (i == 2 && is_free("rotation")),
                    ExcMessage("'Moment " + component +
                               "' is set but 'Free motions' has no 'rotation " +
                               component + "'."));
      }
    AssertThrow((type == "formula") != formula.empty(),
                ExcMessage(
                  "'Type' is '" + type + "' and 'Formula' is '" + formula +
                  "'; expected a formula with Type = formula, and none "
                  "without."));
    AssertThrow((type == "mesh") != file.empty(),
                ExcMessage("'Type' is '" + type + "' and 'File' is '" + file +
                           "'; expected a file with Type = mesh, and none "
                           "without."));
    AssertThrow((type == "box" || type == "ellipsoid") != sizes.empty(),
                ExcMessage(
                  "'Type' is '" + type + "' and 'Sizes' has " +
                  std::to_string(sizes.size()) +
                  " numbers; box and ellipsoid need sizes, others have "
                  "none."));
    for (const double s : sizes)
      AssertThrow(s > 0.,
                  ExcMessage("'Sizes' has " + std::to_string(s) +
                             "; expected positive numbers."));
    AssertThrow(thickness == 0. || (type == "mesh" && !smooth),
                ExcMessage("'Thickness' is set: expected Type = mesh and "
                           "Smooth = no."));
    AssertThrow(!smooth || type == "mesh",
                ExcMessage("'Smooth' is 'yes' but 'Type' is '" + type +
                           "'; only a mesh has facets."));
    AssertThrow(type != "torus" || tube_radius < radius,
                ExcMessage("'Tube radius' is " + std::to_string(tube_radius) +
                           "; expected less than 'Radius', " +
                           std::to_string(radius) + "."));
  }


  template <int dim>
  std::shared_ptr<RigidBody<dim>>
  RigidParameters::make(const double scene_length) const
  {
    // Step 1: the shape.
    std::shared_ptr<RigidBody<dim>> body;
    if (type == "mesh")
      {
        std::vector<Tensor<1, dim>>            vertices;
        std::vector<std::vector<unsigned int>> facets = this->facets;
        if (file.empty())
          for (const Tensor<1, 3> &given : this->vertices)
            {
              vertices.emplace_back();
              for (unsigned int i = 0; i < dim; ++i)
                vertices.back()[i] = given[i];
            }
        else
          read_surface<dim>(file, vertices, facets);
        for (auto &v : vertices)
          v *= scale;
        if constexpr (dim == 3)
          if (thickness > 0.)
            thicken(thickness, vertices, facets);
        AssertThrow(dim == 3 || thickness == 0.,
                    ExcMessage("'Thickness' is set but 'Dimension' is 2."));
        if (smooth)
          {
            std::vector<Facet<dim>> all;
            for (const auto &f : facets)
              {
                Facet<dim> facet;
                facet.n_vertices = f.size();
                for (unsigned int a = 0; a < f.size(); ++a)
                  facet.x[a] = vertices[f[a]];
                all.push_back(facet);
              }
            body = std::make_shared<RigidBody<dim>>(
              name,
              std::make_unique<SmoothFacets<dim>>(all,
                                                  crease_angle * numbers::PI /
                                                    180.));
          }
        else
          body = std::make_shared<RigidBody<dim>>(name, vertices, facets);
      }
    else
      {
        std::unique_ptr<ImplicitShape<dim>> shape;
        if (type == "ball")
          shape = ball_shape<dim>(radius);
        else if (type == "plane")
          shape = plane_shape<dim>();
        else if (type == "box")
          shape = box_shape<dim>(vector_of<dim>(sizes, "Sizes"));
        else if (type == "ellipsoid")
          shape = ellipsoid_shape<dim>(vector_of<dim>(sizes, "Sizes"));
        else if (type == "formula")
          shape = formula_shape<dim>(formula, formula_step * scene_length);
        else if constexpr (dim == 3)
          {
            if (type == "cylinder")
              shape = cylinder_shape(radius, length);
            else if (type == "cone")
              shape = cone_shape(half_angle * numbers::PI / 180.);
            else
              shape = torus_shape(radius, tube_radius);
          }
        else
          AssertThrow(false,
                      ExcMessage(
                        "'Type' is '" + type +
                        "' but 'Dimension' is 2; expected ball, plane, "
                        "box, ellipsoid, formula or mesh."));
        body = std::make_shared<RigidBody<dim>>(
          name, std::make_unique<ImplicitObstacle<dim>>(std::move(shape)));
      }

    // Step 2: the motion, x = C + u + R (P + R_0 X - C).
    const Tensor<1, dim> P = vector_of<dim>(position, "Position");
    const Tensor<1, dim> C = turning_point<dim>();
    Tensor<1, dim>       last;
    last[dim - 1] = 1.;
    const Tensor<1, dim> direction =
      axis.empty() ? last : vector_of<dim>(axis, "Axis");
    AssertThrow(direction.norm() > 0.,
                ExcMessage("'Axis' is 0; expected a direction."));
    const Tensor<2, dim> R0 = rotation_to(direction);
    Tensor<1, 3>         turn_axis({0., 0., 1.});
    if (!rotation_axis.empty())
      {
        AssertThrow(dim == 3,
                    ExcMessage("'Rotation axis' is set but 'Dimension' is 2."));
        turn_axis = vector_of<3>(rotation_axis, "Rotation axis");
        AssertThrow(turn_axis.norm() > 0.,
                    ExcMessage("'Rotation axis' is 0; expected a direction."));
        turn_axis /= turn_axis.norm();
      }
    AssertThrow(dim == 3 || translation[2] == "0",
                ExcMessage("'Move z' is set but 'Dimension' is 2."));
    auto formulas = std::make_shared<std::vector<Expression<dim>>>();
    for (unsigned int i = 0; i < dim; ++i)
      formulas->emplace_back(translation[i],
                             "Rigid bodies/" + name + "/Move " +
                               std::string(1, "xyz"[i]));
    formulas->emplace_back(rotation_angle,
                           "Rigid bodies/" + name + "/Rotation angle");
    body->prescribed = [formulas, P, C, R0, turn_axis](const double t) {
      RigidMotion<dim>     m;
      const Tensor<2, dim> R =
        rotation_by<dim>((*formulas)[dim].value(Point<dim>(), t) * turn_axis);
      m.rotation    = R * R0;
      m.translation = C + R * (P - C);
      for (unsigned int i = 0; i < dim; ++i)
        m.translation[i] += (*formulas)[i].value(Point<dim>(), t);
      return m;
    };
    return body;
  }


  template <int dim>
  Tensor<1, dim>
  RigidParameters::turning_point() const
  {
    return rotation_centre.empty() ?
             vector_of<dim>(position, "Position") :
             vector_of<dim>(rotation_centre, "Rotation centre");
  }


  template <int dim>
  Tensor<1, 3>
  RigidParameters::shift(const double time) const
  {
    Tensor<1, 3> u;
    for (unsigned int i = 0; i < dim; ++i)
      u[i] = Expression<dim>(translation[i], "Move").value(Point<dim>(), time);
    return u;
  }


  template Tensor<1, 2>
  RigidParameters::turning_point<2>() const;
  template Tensor<1, 3>
  RigidParameters::turning_point<3>() const;
  template Tensor<1, 3>
  RigidParameters::shift<2>(const double) const;
  template Tensor<1, 3>
  RigidParameters::shift<3>(const double) const;
  template std::shared_ptr<RigidBody<2>>
  RigidParameters::make<2>(const double) const;
  template std::shared_ptr<RigidBody<3>>
  RigidParameters::make<3>(const double) const;
} // namespace Structure
