// SPDX-License-Identifier: LGPL-2.1-or-later
#include "leaflets.h"

#include <mortar_contact/laws/contact_modulus.h>

#include <deal.II/fe/fe_q.h>

#include <deal.II/numerics/data_out.h>

#include <fstream>

namespace Immersed
{
  namespace
  {
    // boundary ids of end points
    constexpr types::boundary_id root_id = 0, tip_id = 1;

    constexpr unsigned int n_dofs = 2 * BeamElement::n_nodes;

    double
    mean_cell_length(const std::vector<Leaflet> &leaflets)
    {
      double       length  = 0.;
      unsigned int n_cells = 0;
      for (const auto &leaflet : leaflets)
        {
          length += leaflet.root.distance(leaflet.tip);
          n_cells += leaflet.n_cells;
        }
      return length / std::max(1u, n_cells);
    }
  } // namespace


  Leaflets::Leaflets(const std::vector<Leaflet> &leaflets,
                     const BeamMaterial         &material)
    : scale(mean_cell_length(leaflets))
    , fe(FE_Q<1, 2>(1), 4)
    , dof_handler(triangulation)
    , leaflets(leaflets)
    , material(material)
  {
    std::vector<Point<2>>    vertices;
    std::vector<CellData<1>> cells;
    for (unsigned int l = 0; l < leaflets.size(); ++l)
      {
        const Leaflet     &leaflet = leaflets[l];
        const Tensor<1, 2> along   = leaflet.tip - leaflet.root;
        const unsigned int n       = leaflet.n_cells;
        for (unsigned int i = 0; i <= n; ++i)
          {
            vertices.push_back(leaflet.root + (1. * i / n) * along);
            // to the left of the direction, see ShellSkin::orientation
            directors.push_back(Tensor<1, 2>({-along[1], along[0]}) /
                                along.norm());
            if (i == n)
              break;
            CellData<1> cell;
            cell.vertices[0] = vertices.size() - 1;
            cell.vertices[1] = vertices.size();
            cell.material_id = l;
            cells.push_back(cell);
          }
        tips.push_back(vertices.size() - 1);
      }
    triangulation.create_triangulation(vertices, cells, SubCellData());
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(cell->face(f)->vertex_index() ==
                                             tips[cell->material_id()] ?
                                           tip_id :
                                           root_id);
    dof_handler.distribute_dofs(fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        BeamElement::Nodes nodes;
        for (unsigned int a = 0; a < 2; ++a)
          {
            nodes[a]     = cell->vertex(a);
            nodes[2 + a] = directors[cell->vertex_index(a)];
          }
        reference.push_back(nodes);
        elements.emplace_back(material, nodes);
      }
  }


  std::vector<types::global_dof_index>
  Leaflets::dofs_of(const DoFHandler<1, 2>::active_cell_iterator &cell) const
  {
    std::vector<types::global_dof_index> dofs(n_dofs);
    for (unsigned int i = 0; i < BeamElement::n_nodes; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        dofs[2 * i + c] = cell->vertex_dof_index(i % 2, 2 * (i / 2) + c);
    return dofs;
  }


  BeamElement::Nodes
  Leaflets::changes_of(const std::vector<types::global_dof_index> &dofs,
                       const Vector<double>                       &u) const
  {
    BeamElement::Nodes changes;
    for (unsigned int i = 0; i < BeamElement::n_nodes; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        changes[i][c] = u(dofs[2 * i + c]) / (i < 2 ? 1. : scale);
    return changes;
  }


  BeamElement::Nodes
  Leaflets::nodes_of(const std::vector<types::global_dof_index> &dofs,
                     const unsigned int                          cell,
                     const Vector<double>                       &u) const
  {
    BeamElement::Nodes nodes = changes_of(dofs, u);
    for (unsigned int i = 0; i < BeamElement::n_nodes; ++i)
      nodes[i] += reference[cell][i];
    return nodes;
  }


  void
  Leaflets::constrain(AffineConstraints<double> &constraints) const
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (unsigned int a = 0; a < 2; ++a)
        if (leaflets[cell->material_id()].is_rigid ||
            (cell->face(a)->at_boundary() &&
             cell->face(a)->boundary_id() == root_id))
          for (unsigned int c = 0; c < fe.n_components(); ++c)
            constraints.add_line(cell->vertex_dof_index(a, c));
  }


  void
  Leaflets::add_couplings(DynamicSparsityPattern          &sparsity,
                          const AffineConstraints<double> &constraints) const
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      constraints.add_entries_local_to_global(dofs_of(cell), sparsity, false);
  }


  void
  Leaflets::assemble(const Vector<double>            &u,
                     const Vector<double>            &update,
                     const State                     &old,
                     const double                     time_step,
                     const AffineConstraints<double> &constraints,
                     SparseMatrix<double>            &matrix,
                     Vector<double>                  &rhs) const
  {
    Vector<double>     f;
    FullMatrix<double> K;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const unsigned int e    = cell->active_cell_index();
        const auto         dofs = dofs_of(cell);
        elements[e].differentiate(nodes_of(dofs, e, u),
                                  changes_of(dofs, update),
                                  f,
                                  &K);
        const auto unit = [&](const unsigned int i) {
          return i < 4 ? 1. : 1. / scale;
        };
        for (unsigned int i = 0; i < n_dofs; ++i)
          {
            f(i) *= -unit(i);
            for (unsigned int j = 0; j < n_dofs; ++j)
              K(i, j) *= unit(i) * unit(j);
          }
        if (time_step > 0.)
          for (unsigned int i = 0; i < n_dofs; ++i)
            for (unsigned int j = i % 2; j < n_dofs; j += 2)
              {
                const double m = elements[e].mass(i / 2, j / 2) * unit(i) *
                                 unit(j) / (time_step * time_step);
                K(i, j) += m;
                f(i) -= m * (u(dofs[j]) - old.u(dofs[j]) -
                             time_step * old.rate(dofs[j]));
              }
        constraints.distribute_local_to_global(K, f, dofs, matrix, rhs);
      }
  }


  double
  Leaflets::strain_energy(const Vector<double> &u) const
  {
    double result = 0.;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const unsigned int e = cell->active_cell_index();
        result += elements[e].energy(nodes_of(dofs_of(cell), e, u));
      }
    return result;
  }


  void
  Leaflets::add_to(MortarContact::ContactInterface<2> &contact) const
  {
    MortarContact::ShellSkin<2> skin;
    skin.thickness      = material.thickness;
    skin.director_scale = scale;
    skin.modulus  = MortarContact::bulk_contact_modulus(material.youngs_modulus,
                                                       material.poissons_ratio);
    skin.director = [this](const unsigned int v) { return directors[v]; };
    skin.orientation = [](const unsigned int) { return 1; };
    for (unsigned int l = 0; l < leaflets.size(); ++l)
      {
        MortarContact::FaceSelection selection =
          MortarContact::boundary_ids({tip_id});
        selection.materials = {l};
        contact.add_secondary(dof_handler,
                              selection,
                              skin,
                              "leaflet " + std::to_string(l));
      }
  }


  Point<2>
  Leaflets::place(const unsigned int vertex, const Vector<double> &u) const
  {
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (unsigned int a = 0; a < 2; ++a)
        if (cell->vertex_index(a) == vertex)
          return cell->vertex(a) +
                 Tensor<1, 2>({u(cell->vertex_dof_index(a, 0)),
                               u(cell->vertex_dof_index(a, 1))});
    Assert(false, ExcInternalError());
    return {};
  }


  bool
  Leaflets::is_within(const Point<2>       &low,
                      const Point<2>       &high,
                      const unsigned int    leaflet,
                      const Vector<double> &u) const
  {
    // roots stand on walls
    const double tolerance = 1e-10 * low.distance(high);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->material_id() == leaflet)
        for (unsigned int a = 0; a < 2; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            {
              const double x =
                cell->vertex(a)[c] + u(cell->vertex_dof_index(a, c));
              if (x < low[c] - tolerance || x > high[c] + tolerance)
                return false;
            }
    return true;
  }


  void
  Leaflets::write(const std::string &file, const Vector<double> &u) const
  {
    DataOut<1, 2> data_out;
    using Interpretation =
      DataComponentInterpretation::DataComponentInterpretation;
    data_out.add_data_vector(
      dof_handler,
      u,
      {"displacement", "displacement", "director_change", "director_change"},
      std::vector<Interpretation>(
        4, DataComponentInterpretation::component_is_part_of_vector));
    Vector<double> leaflet(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      leaflet(cell->active_cell_index()) = cell->material_id();
    data_out.add_data_vector(leaflet, "leaflet");
    data_out.build_patches();
    std::ofstream out(file);
    data_out.write_vtu(out);
  }
} // namespace Immersed
