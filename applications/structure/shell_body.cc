// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_body.h"

#include "vtk_flags.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace Structure
{
  namespace
  {
    /// Points and weights on the reference cell, exact for the bilinear
    /// products of loads.
    Quadrature<2>
    rule(const unsigned int n_nodes)
    {
      if (n_nodes == 3)
        return QGaussSimplex<2>(2);
      return QGauss<2>(2);
    }

    /// Triangles of a cell, as numbers of its vertices, around its normal; a
    /// quadrilateral is cut along the shorter diagonal.
    std::vector<std::array<unsigned int, 3>>
    triangles_of(const std::vector<Point<3>> &x)
    {
      if (x.size() == 3)
        return {{{0, 1, 2}}};
      if (x[0].distance(x[3]) < x[1].distance(x[2]))
        return {{{0, 1, 3}}, {{0, 3, 2}}};
      return {{{0, 1, 2}}, {{1, 3, 2}}};
    }
  } // namespace


  ShellBody::ShellBody(const std::string                &name,
                       const Triangulation<2, 3>        &mesh,
                       const ShellParameters            &parameters,
                       const std::vector<SymmetryPlane> &planes,
                       const MPI_Comm                    communicator)
    : MeshBody<2, 3>(name, mesh, /* is_whole = */ false, communicator)
    , parameters(parameters)
  {
    if (!has_simplices_only)
      {
        elements.push_back(FESystem<2, 3>(FE_Q<2, 3>(1), 6));
        mappings.push_back(MappingQ<2, 3>(1));
      }
    if (!has_hypercubes_only)
      {
        elements.push_back(FESystem<2, 3>(FE_SimplexP<2, 3>(1), 6));
        mappings.push_back(MappingFE<2, 3>(FE_SimplexP<2, 3>(1)));
      }
    distribute_dofs();
    set_geometry(mesh, planes);
    for (const Cell &cell : local_cells)
      {
        std::vector<Tensor<1, 3>> R, D;
        for (const unsigned int v : cell->vertex_indices())
          {
            R.push_back(cell->vertex(v));
            D.push_back(directors[cell->vertex_index(v)]);
          }
        shells.emplace_back(R, D, section_of(cell->material_id()), scale);
      }
  }


  void
  ShellBody::set_geometry(const Triangulation<2, 3>        &mesh,
                          const std::vector<SymmetryPlane> &planes)
  {
    // Step 1: of the whole mesh.
    std::vector<int> signs = orient(mesh);
    if (parameters.is_turned)
      for (int &sign : signs)
        sign = -sign;
    const auto normals = directors_of(mesh, signs, planes);
    scale              = parameters.director_scale;
    if (scale == 0.)
      {
        for (const auto &cell : mesh.active_cell_iterators())
          scale += cell->diameter() / std::sqrt(2.);
        scale /= mesh.n_active_cells();
      }
    std::vector<double> thicknesses;
    if (!parameters.thicknesses.empty())
      {
        std::vector<unsigned int> n(mesh.n_vertices(), 0);
        thicknesses.resize(n.size(), 0.);
        for (const auto &cell : mesh.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            {
              ++n[cell->vertex_index(v)];
              thicknesses[cell->vertex_index(v)] +=
                section_of(cell->material_id()).thickness;
            }
        for (std::size_t v = 0; v < n.size(); ++v)
          thicknesses[v] /= std::max(1u, n[v]);
        for (const auto &cell : mesh.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->has_children())
              thicknesses[face->child(0)->vertex_index(1)] =
                0.5 * (thicknesses[face->vertex_index(0)] +
                       thicknesses[face->vertex_index(1)]);
      }

    // Step 2: of what this rank knows, in the order of the whole mesh, too.
    orientation.resize(triangulation.n_active_cells());
    directors.resize(triangulation.n_vertices());
    if (!thicknesses.empty())
      thickness_at.resize(triangulation.n_vertices());
    auto known = dof_handler.begin_active();
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (known == dof_handler.end() ||
            number_of(known) != cell->active_cell_index())
          continue;
        orientation[known->active_cell_index()] =
          signs[cell->active_cell_index()];
        for (const unsigned int v : cell->vertex_indices())
          {
            const unsigned int to   = known->vertex_index(v),
                               from = cell->vertex_index(v);
            directors[to]           = normals[from];
            if (!thicknesses.empty())
              thickness_at[to] = thicknesses[from];
          }
        ++known;
      }
    Assert(known == dof_handler.end(), ExcInternalError());
  }


  ShellSection
  ShellBody::section_of(const types::material_id part) const
  {
    ShellSection section = parameters.section;
    const auto   own     = parameters.thicknesses.find(part);
    if (own != parameters.thicknesses.end())
      section.thickness = own->second;
    return section;
  }


  std::string
  ShellBody::description() const
  {
    std::ostringstream text;
    if (parameters.thicknesses.empty())
      text << ", shell of thickness " << parameters.section.thickness;
    else
      for (const auto &[part, thickness] : parameters.thicknesses)
        text << ", part " << part << " of thickness " << thickness;
    text << (parameters.section.is_neo_hookean ? " (neo-Hookean)" :
             parameters.section.hardening.yield_stress > 0. ?
                                                 " (elastic-plastic)" :
                                                 " (St. Venant-Kirchhoff)");
    return text.str();
  }


  double
  ShellBody::force_scale(const double size) const
  {
    return parameters.section.youngs_modulus /
           (2. * (1. + parameters.section.poissons_ratio)) *
           parameters.section.thickness * size;
  }


  bool
  ShellBody::evaluate(const unsigned int    cell,
                      const Vector<double> &u,
                      const Vector<double> *previous,
                      const bool            with_tangent,
                      Vector<double>       &forces,
                      FullMatrix<double>   &tangent)
  {
    return shells[cell].evaluate(u, with_tangent, previous, forces, tangent) &&
           std::isfinite(forces.l2_norm());
  }


  void
  ShellBody::evaluate_step(const unsigned int    cell,
                           const Vector<double> &u_n,
                           const Vector<double> &u,
                           const Vector<double> *previous,
                           const bool            with_tangent,
                           Vector<double>       &forces,
                           FullMatrix<double>   &tangent)
  {
    shells[cell].evaluate_step(u_n, u, with_tangent, previous, forces, tangent);
  }


  void
  ShellBody::commit()
  {
    for (ShellElement &element : shells)
      element.commit();
  }


  std::vector<double>
  ShellBody::history() const
  {
    std::vector<std::vector<double>> of_cells;
    const std::size_t                n = n_history();
    for (const ShellElement &element : shells)
      {
        of_cells.emplace_back();
        for (const PlasticState &s : element.states)
          of_cells.back().insert(
            of_cells.back().end(),
            {s.strain[0], s.strain[1], s.strain[2], s.equivalent});
        of_cells.back().insert(of_cells.back().end(),
                               element.modes.begin(),
                               element.modes.end());
        of_cells.back().resize(n, 0.);
      }
    return of_all_cells(of_cells);
  }


  std::size_t
  ShellBody::n_history() const
  {
    std::size_t n = 0;
    for (const ShellElement &element : shells)
      n = std::max(n, 4 * element.states.size() + element.modes.size());
    return Utilities::MPI::max(n, communicator);
  }


  void
  ShellBody::restore(const std::vector<double> &state)
  {
    const std::size_t n = n_history();
    AssertThrow(state.size() == n * n_cells(),
                ExcMessage("The saved state belongs to another shell."));
    for (std::size_t cell = 0; cell < shells.size(); ++cell)
      {
        std::size_t i = n * number_of(local_cells[cell]);
        for (PlasticState &s : shells[cell].states)
          {
            s = {{{state[i], state[i + 1], state[i + 2]}}, state[i + 3]};
            i += 4;
          }
        for (double &mode : shells[cell].modes)
          mode = state[i++];
      }
  }


  double
  ShellBody::energy(const unsigned int cell, const Vector<double> &u)
  {
    return shells[cell].energy(u);
  }


  void
  ShellBody::mass(const unsigned int cell, FullMatrix<double> &matrix)
  {
    shells[cell].mass(matrix);
  }


  void
  ShellBody::add_load(const unsigned int    cell,
                      Load<3>              &load,
                      const Vector<double> &u,
                      const double          time,
                      Vector<double>       &forces,
                      FullMatrix<double>   &tangent)
  {
    using Type           = Load<3>::Type;
    const Cell         c = local_cells[cell];
    const unsigned int n = c->n_vertices();
    const auto dead = [&](const Point<3> &x, const double w, const auto &N) {
      for (unsigned int i = 0; i < 3; ++i)
        if (load.of_component[i] >= 0)
          {
            const double f =
              w * load.formulas[load.of_component[i]].value(x, time);
            for (unsigned int a = 0; a < n; ++a)
              forces(6 * a + i) += f * N[a];
          }
    };

    if (load.type != Type::body_force && !load.on_surface)
      {
        // edges: exact for linear tractions
        for (const unsigned int f : c->face_indices())
          {
            if (!c->face(f)->at_boundary() ||
                load.boundaries.count(c->face(f)->boundary_id()) == 0)
              continue;
            std::vector<unsigned int> ends;
            for (const unsigned int v : c->vertex_indices())
              for (const unsigned int w : c->face(f)->vertex_indices())
                if (c->vertex_index(v) == c->face(f)->vertex_index(w))
                  ends.push_back(v);
            const QGauss<1> gauss(2);
            for (unsigned int q = 0; q < gauss.size(); ++q)
              {
                std::vector<double> N(n, 0.);
                N[ends[0]] = 1. - gauss.point(q)[0];
                N[ends[1]] = gauss.point(q)[0];
                const Point<3> x =
                  c->vertex(ends[0]) +
                  N[ends[1]] * (c->vertex(ends[1]) - c->vertex(ends[0]));
                const double w = gauss.weight(q) * c->face(f)->measure();
                if (load.type == Type::moment)
                  add_moment(c, x, w, N, load, u, time, forces, tangent);
                else
                  dead(x, w, N);
              }
          }
        return;
      }

    const FiniteElement<2, 3> &scalar = c->get_fe().base_element(0);
    const Quadrature<2>        points = rule(n);
    const int                  top    = orientation[c->active_cell_index()];
    for (unsigned int q = 0; q < points.size(); ++q)
      {
        std::vector<double>       N(n);
        std::vector<Tensor<1, 2>> dN(n);
        Point<3>                  X;
        Tensor<1, 3>              X_r, X_s, x_r, x_s;
        for (unsigned int a = 0; a < n; ++a)
          {
            N[a]                 = scalar.shape_value(a, points.point(q));
            dN[a]                = scalar.shape_grad(a, points.point(q));
            const Tensor<1, 3> R = c->vertex(a);
            const Tensor<1, 3> r =
              R + Tensor<1, 3>({u(6 * a), u(6 * a + 1), u(6 * a + 2)});
            X += N[a] * R;
            X_r += dN[a][0] * R;
            X_s += dN[a][1] * R;
            x_r += dN[a][0] * r;
            x_s += dN[a][1] * r;
          }
        const double w = points.weight(q);
        if (load.type != Type::pressure)
          {
            const double per_volume = load.type == Type::body_force ?
                                        section_of(c->material_id()).thickness :
                                        1.;
            dead(X, per_volume * w * cross_product_3d(X_r, X_s).norm(), N);
            continue;
          }
        // against the top: - p (x_r x x_s) of the present shape
        const double       p = top * w * load.formulas[0].value(X, time);
        const Tensor<1, 3> m = cross_product_3d(x_r, x_s);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < 3; ++i)
            forces(6 * a + i) -= p * m[i] * N[a];
        if (tangent.empty())
          continue;
        for (unsigned int b = 0; b < n; ++b)
          for (unsigned int k = 0; k < 3; ++k)
            {
              Tensor<1, 3> e;
              e[k]                  = 1.;
              const Tensor<1, 3> dm = dN[b][0] * cross_product_3d(e, x_s) +
                                      dN[b][1] * cross_product_3d(x_r, e);
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int i = 0; i < 3; ++i)
                  tangent(6 * a + i, 6 * b + k) += p * dm[i] * N[a];
            }
      }
  }


  void
  ShellBody::add_moment(const Cell                &cell,
                        const Point<3>            &x,
                        const double               weight,
                        const std::vector<double> &N,
                        Load<3>                   &load,
                        const Vector<double>      &u,
                        const double               time,
                        Vector<double>            &forces,
                        FullMatrix<double>        &tangent) const
  {
    Tensor<1, 3> m, d;
    for (unsigned int i = 0; i < 3; ++i)
      if (load.of_component[i] >= 0)
        m[i] =
          weight * load.formulas[load.of_component[i]].value(x, time) / scale;
    for (unsigned int a = 0; a < N.size(); ++a)
      d += N[a] *
           (directors[cell->vertex_index(a)] +
            Tensor<1, 3>({u(6 * a + 3), u(6 * a + 4), u(6 * a + 5)}) / scale);
    const Tensor<1, 3> force = cross_product_3d(m, d) / d.norm_square();
    for (unsigned int a = 0; a < N.size(); ++a)
      for (unsigned int i = 0; i < 3; ++i)
        forces(6 * a + 3 + i) += N[a] * force[i];
    if (tangent.empty())
      return;
    for (unsigned int k = 0; k < 3; ++k)
      {
        Tensor<1, 3> e;
        e[k] = 1. / scale;
        const Tensor<1, 3> change =
          (cross_product_3d(m, e) - 2. * (d * e) * force) / d.norm_square();
        for (unsigned int a = 0; a < N.size(); ++a)
          for (unsigned int b = 0; b < N.size(); ++b)
            for (unsigned int i = 0; i < 3; ++i)
              tangent(6 * a + 3 + i, 6 * b + 3 + k) -= N[a] * N[b] * change[i];
      }
  }


  DoFPlace<3>
  ShellBody::place_of(const unsigned int cell, const unsigned int dof) const
  {
    const unsigned int vertex = dof / 6, component = dof % 6;
    const Point<3>     x = local_cells[cell]->vertex(vertex);
    return {x,
            component,
            component < 3 ?
              Tensor<1, 3>(x) :
              scale * directors[local_cells[cell]->vertex_index(vertex)]};
  }


  BoundaryNode<3>
  ShellBody::node_of(const Cell &cell, const unsigned int vertex) const
  {
    BoundaryNode<3> node;
    node.x            = cell->vertex(vertex);
    node.cell         = number_of(cell);
    node.has_director = true;
    for (unsigned int i = 0; i < 3; ++i)
      {
        node.dofs[i] = numbering(cell->vertex_dof_index(vertex, i));
        node.director_dofs[i] =
          numbering(cell->vertex_dof_index(vertex, 3 + i));
      }
    return node;
  }


  void
  ShellBody::visit_boundary_nodes(const std::set<types::boundary_id> &ids,
                                  const Visitor &visit) const
  {
    for (const Cell &cell : local_cells)
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            ids.count(cell->face(f)->boundary_id()) > 0)
          for (const unsigned int v : cell->vertex_indices())
            for (const unsigned int w : cell->face(f)->vertex_indices())
              if (cell->vertex_index(v) == cell->face(f)->vertex_index(w))
                visit(node_of(cell, v));
  }


  void
  ShellBody::visit_nodes(const Visitor &visit) const
  {
    for (const Cell &cell : local_cells)
      for (const unsigned int v : cell->vertex_indices())
        visit(node_of(cell, v));
  }


  void
  ShellBody::add_to(MortarContact::ContactInterface<3> &interface,
                    const bool                          secondary,
                    const MortarContact::FaceSelection &faces) const
  {
    MortarContact::ShellSkin<3> skin;
    skin.thickness      = parameters.section.thickness;
    skin.director_scale = scale;
    if (!thickness_at.empty())
      {
        skin.thickness =
          *std::max_element(thickness_at.begin(), thickness_at.end());
        skin.thickness_at = [this](const unsigned int vertex) {
          return skin_thickness(vertex);
        };
      }
    skin.modulus  = parameters.contact_modulus;
    skin.director = [this](const unsigned int vertex) {
      return directors[vertex];
    };
    skin.orientation = [this](const unsigned int cell) {
      return orientation[cell];
    };
    // boundary ids are those of edges
    MortarContact::FaceSelection chosen = faces;
    if (!faces.boundaries.empty())
      chosen.top = chosen.bottom = false;
    if (secondary)
      interface.add_secondary(dof_handler, chosen, skin, name, numbering);
    else
      interface.add_primary(dof_handler, chosen, skin, name, numbering);
  }


  std::vector<MidTriangle>
  ShellBody::mid_surface() const
  {
    std::vector<std::vector<MidTriangle>> of_cells;
    for (const Cell &cell : local_cells)
      {
        of_cells.emplace_back();
        const double thickness = section_of(cell->material_id()).thickness;
        std::vector<Point<3>> x;
        for (const unsigned int v : cell->vertex_indices())
          x.push_back(cell->vertex(v));
        for (const auto &corners : triangles_of(x))
          {
            MidTriangle triangle;
            triangle.thickness = thickness;
            triangle.part      = cell->material_id();
            for (unsigned int a = 0; a < 3; ++a)
              {
                const BoundaryNode<3> node = node_of(cell, corners[a]);
                triangle.dofs[a]           = node.dofs;
                triangle.x[a]              = node.x;
              }
            of_cells.back().push_back(triangle);
          }
      }
    return of_all_cells(of_cells);
  }


  std::vector<std::array<Point<3>, 3>>
  ShellBody::outer_surface(const Vector<double> &u, const double offset) const
  {
    std::vector<std::vector<std::array<Point<3>, 3>>> of_cells;
    for (const Cell &cell : local_cells)
      {
        of_cells.emplace_back();
        auto &triangles = of_cells.back();
        // mid-surface, and from there to the top
        std::vector<Point<3>>     x;
        std::vector<Tensor<1, 3>> up;
        for (const unsigned int v : cell->vertex_indices())
          {
            const BoundaryNode<3> node   = node_of(cell, v);
            const unsigned int    vertex = cell->vertex_index(v);
            Tensor<1, 3>          d      = directors[vertex];
            x.push_back(node.x);
            for (unsigned int i = 0; i < 3; ++i)
              {
                x[v][i] += u(node.dofs[i]);
                d[i] += u(node.director_dofs[i]) / scale;
              }
            up.push_back((0.5 * skin_thickness(vertex) + offset / d.norm()) *
                         d);
          }
        const bool is_turned = orientation[cell->active_cell_index()] < 0;
        for (std::array<unsigned int, 3> corners : triangles_of(x))
          {
            if (is_turned)
              std::swap(corners[1], corners[2]);
            const auto [a, b, c] = corners;
            triangles.push_back({{x[a] + up[a], x[b] + up[b], x[c] + up[c]}});
            triangles.push_back({{x[a] - up[a], x[c] - up[c], x[b] - up[b]}});
          }
        // free edges: from the bottom to the top, in the order of the top's
        const std::vector<unsigned int> ring =
          x.size() == 4 ? std::vector<unsigned int>{0, 1, 3, 2} :
                          std::vector<unsigned int>{0, 1, 2};
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (unsigned int k = 0; k < ring.size(); ++k)
              {
                unsigned int a = ring[k], b = ring[(k + 1) % ring.size()];
                const std::set<unsigned int> ends = {cell->vertex_index(a),
                                                     cell->vertex_index(b)};
                if (ends.count(face->vertex_index(0)) == 0 ||
                    ends.count(face->vertex_index(1)) == 0)
                  continue;
                if (is_turned)
                  std::swap(a, b);
                triangles.push_back(
                  {{x[b] + up[b], x[a] + up[a], x[a] - up[a]}});
                triangles.push_back(
                  {{x[b] + up[b], x[a] - up[a], x[b] - up[b]}});
              }
      }
    return of_all_cells(of_cells);
  }


  void
  ShellBody::write(const ValuesOfCell &values_of_cell,
                   const std::string  &file,
                   const MPI_Comm      communicator)
  {
    Vector<double>     fields(dof_handler.n_dofs());
    const unsigned int n_cells = triangulation.n_active_cells();
    Vector<double>     top(n_cells), middle(n_cells), bottom(n_cells),
      largest(n_cells), plastic(n_cells);
    std::vector<types::global_dof_index> dofs;
    for (unsigned int i = 0; i < local_cells.size(); ++i)
      {
        dofs.resize(n_dofs_per_cell(i));
        const Vector<double> &values = values_of_cell(i);
        local_cells[i]->get_dof_indices(dofs);
        for (unsigned int a = 0; a < dofs.size(); ++a)
          fields(dofs[a]) = values(a) / (a % 6 < 3 ? 1. : scale);
        const auto mises = [&](const double height) {
          return von_mises(shells[i].stress(values, height));
        };
        const unsigned int c = local_cells[i]->active_cell_index();
        top(c)               = mises(1.);
        middle(c)            = mises(0.);
        bottom(c)            = mises(-1.);
        largest(c)           = std::max({top(c), middle(c), bottom(c)});
        plastic(c)           = shells[i].plastic_strain();
      }

    using Kind = DataComponentInterpretation::DataComponentInterpretation;
    std::vector<std::string> names(3, "displacement");
    names.insert(names.end(), 3, "director_change");
    DataOut<2, 3> data_out;
    data_out.attach_dof_handler(dof_handler);
    data_out.add_data_vector(
      fields,
      names,
      DataOut<2, 3>::type_dof_data,
      std::vector<Kind>(
        6, DataComponentInterpretation::component_is_part_of_vector));
    const std::pair<const char *, const Vector<double> *> stresses[] = {
      {"von_Mises", &largest},
      {"von_Mises_top", &top},
      {"von_Mises_middle", &middle},
      {"von_Mises_bottom", &bottom}};
    for (const auto &[what, values] : stresses)
      data_out.add_data_vector(*values, what, DataOut<2, 3>::type_cell_data);
    if (parameters.section.hardening.yield_stress > 0.)
      data_out.add_data_vector(plastic,
                               "plastic_strain",
                               DataOut<2, 3>::type_cell_data);
    data_out.build_patches(mappings);
    data_out.set_flags(fast_vtk_flags());
    data_out.write_vtu_in_parallel(file, communicator);
  }
} // namespace Structure
