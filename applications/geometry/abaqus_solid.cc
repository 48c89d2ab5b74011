// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_solid.h"

#include "abaqus_deck.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace Structure
{
  namespace
  {
    /// Nodes of the faces S1, S2, ..., counted from 0 in Abaqus' order.
    std::vector<std::vector<unsigned int>>
    faces_of(const unsigned int dim, const unsigned int n_nodes)
    {
      if (dim == 2)
        return n_nodes == 3 ? std::vector<std::vector<unsigned int>>{{0, 1},
                                                                     {1, 2},
                                                                     {2, 0}} :
                              std::vector<std::vector<unsigned int>>{{0, 1},
                                                                     {1, 2},
                                                                     {2, 3},
                                                                     {3, 0}};
      if (n_nodes == 4)
        return {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
      return {{0, 1, 2, 3},
              {4, 7, 6, 5},
              {0, 4, 5, 1},
              {1, 5, 6, 2},
              {2, 6, 7, 3},
              {3, 7, 4, 0}};
    }

    /// Place of a vertex of a cell in Abaqus' order: around quadrilaterals,
    /// deal.II's is line by line.
    template <int dim>
    unsigned int
    place_of(const unsigned int vertex, const unsigned int n_nodes)
    {
      const bool is_simplex = n_nodes == dim + 1;
      return (is_simplex || vertex % 4 < 2) ? vertex : vertex ^ 1u;
    }

    /// Turn a simplex with a negative volume over.
    template <int dim>
    void
    turn_simplex(const std::vector<Point<dim>> &x, CellData<dim> &cell)
    {
      Tensor<2, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
        edges[d] = x[cell.vertices[d + 1]] - x[cell.vertices[0]];
      if (determinant(edges) < 0.)
        std::swap(cell.vertices[1], cell.vertices[2]);
    }
  } // namespace


  template <int dim>
  MeshParts
  read_abaqus_solid(const std::string &file, Triangulation<dim> &mesh)
  {
    const AbaqusDeck deck =
      read_abaqus(file, dim == 2 ? AbaqusKind::plane : AbaqusKind::solid);
    const std::string is = "'Mesh/File' is '" + file + "': ";

    // Step 1: nodes that elements have.
    std::map<unsigned long, unsigned int> vertex_of;
    std::vector<Point<dim>>               vertices;
    for (const auto &element : deck.elements)
      for (const unsigned long n : element.second)
        if (vertex_of.try_emplace(n, vertices.size()).second)
          {
            Point<dim> x;
            for (unsigned int d = 0; d < dim; ++d)
              x[d] = deck.nodes.at(n)[d];
            vertices.push_back(x);
          }

    // Step 2: cells.
    std::vector<CellData<dim>> cells;
    const std::size_t          n_nodes = deck.elements.begin()->second.size();
    for (const auto &[element, nodes] : deck.elements)
      {
        AssertThrow(nodes.size() == n_nodes,
                    ExcMessage(is + "element " + std::to_string(element) +
                               " has " + std::to_string(nodes.size()) +
                               " nodes, others " + std::to_string(n_nodes) +
                               "; expected one type of elements."));
        AssertThrow(
          std::set<unsigned long>(nodes.begin(), nodes.end()).size() == n_nodes,
          ExcMessage(is + "element " + std::to_string(element) +
                     " has a node twice."));
        CellData<dim> cell(n_nodes);
        for (unsigned int v = 0; v < n_nodes; ++v)
          cell.vertices[v] = vertex_of.at(nodes[place_of<dim>(v, n_nodes)]);
        cell.material_id = deck.part_of.at(element);
        if (n_nodes == dim + 1)
          turn_simplex(vertices, cell);
        cells.push_back(cell);
      }
    try
      {
        if (n_nodes != dim + 1)
          {
            GridTools::invert_all_negative_measure_cells(vertices, cells);
            GridTools::consistently_order_cells(cells);
          }
        mesh.create_triangulation(vertices, cells, SubCellData());
      }
    catch (const std::exception &)
      {
        throw ExcMessage(is + "its elements overlap or are inside out; "
                              "expected a mesh of convex cells that share "
                              "whole faces.");
      }

    // Step 3: surfaces, the first last so that it stays.
    std::map<std::set<unsigned int>, types::boundary_id> id_of;
    const auto faces = faces_of(dim, n_nodes);
    for (unsigned int s = deck.surfaces.size(); s-- > 0;)
      for (const auto &[element, face] : deck.surfaces[s].second)
        {
          const auto found = deck.elements.find(element);
          AssertThrow(found != deck.elements.end() && face <= faces.size(),
                      ExcMessage(is + "*SURFACE '" + deck.surfaces[s].first +
                                 "' has face S" + std::to_string(face) +
                                 " of element " + std::to_string(element) +
                                 ", which is not there."));
          std::set<unsigned int> corners;
          for (const unsigned int v : faces[face - 1])
            corners.insert(vertex_of.at(found->second[v]));
          id_of[corners] = s + 1;
        }
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            std::set<unsigned int> corners;
            for (const unsigned int v : face->vertex_indices())
              corners.insert(face->vertex_index(v));
            const auto id = id_of.find(corners);
            face->set_boundary_id(id == id_of.end() ? 0 : id->second);
          }
    MeshParts parts;
    parts.names = deck.part_ids;
    for (unsigned int i = 0; i < deck.surfaces.size(); ++i)
      parts.boundaries.emplace(deck.surfaces[i].first, i + 1);
    return parts;
  }


  template MeshParts
  read_abaqus_solid(const std::string &, Triangulation<2> &);
  template MeshParts
  read_abaqus_solid(const std::string &, Triangulation<3> &);
} // namespace Structure
