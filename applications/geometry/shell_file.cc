// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_file.h"

#include "abaqus_deck.h"

#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

namespace Structure
{
  MeshParts
  read_abaqus_shell(const std::string &file, Triangulation<2, 3> &mesh)
  {
    const AbaqusDeck  deck = read_abaqus(file, AbaqusKind::shell);
    const std::string is   = "'Mesh/File' is '" + file + "': ";
    MeshParts         parts;
    parts.names = deck.part_ids;
    for (const auto &[name, thickness] : deck.thickness)
      parts.thickness[deck.part_ids.at(name)] = thickness;

    std::map<unsigned long, unsigned int> vertex_of;
    std::vector<Point<3>>                 vertices;
    for (const auto &[node, x] : deck.nodes)
      {
        vertex_of[node] = vertices.size();
        vertices.push_back(x);
      }
    std::vector<CellData<2>> cells;
    for (const auto &[element, nodes] : deck.elements)
      {
        // Abaqus allows triangles as quadrilaterals with two equal nodes
        std::vector<unsigned long> distinct;
        for (const unsigned long n : nodes)
          if (std::find(distinct.begin(), distinct.end(), n) == distinct.end())
            distinct.push_back(n);
        CellData<2> cell(distinct.size());
        for (std::size_t v = 0; v < distinct.size(); ++v)
          cell.vertices[v] = vertex_of.at(distinct[v]);
        AssertThrow(distinct.size() >= 3,
                    ExcMessage(is + "element " + std::to_string(element) +
                               " has fewer than 3 different nodes."));
        if (distinct.size() == 4)
          std::swap(cell.vertices[2], cell.vertices[3]);
        cell.material_id = deck.part_of.at(element);
        cells.push_back(cell);
      }
    SubCellData none;
    GridTools::delete_unused_vertices(vertices, cells, none);
    // quadrilaterals first: edges of triangles have no direction
    const auto first_triangle =
      std::stable_partition(cells.begin(), cells.end(), [](const auto &c) {
        return c.vertices.size() == 4;
      });
    std::vector<CellData<2>> quadrilaterals(cells.begin(), first_triangle);
    if (!quadrilaterals.empty())
      GridTools::consistently_order_cells(quadrilaterals);
    std::copy(quadrilaterals.begin(), quadrilaterals.end(), cells.begin());
    mesh.create_triangulation(vertices, cells, none);
    return parts;
  }


  MeshParts
  gmsh_parts(const std::string &file, const unsigned int dim)
  {
    MeshParts     parts;
    std::ifstream in(file);
    std::string   line;
    while (std::getline(in, line) && Utilities::trim(line) != "$PhysicalNames")
      ;
    unsigned int n = 0;
    in >> n;
    for (unsigned int i = 0; i < n && std::getline(in >> std::ws, line); ++i)
      {
        std::istringstream words(line);
        unsigned int       dimension = 0, id = 0;
        std::string        name;
        words >> dimension >> id;
        std::getline(words >> std::ws, name);
        if (name.size() <= 2)
          continue;
        name = name.substr(1, name.rfind('"') - 1);
        if (dimension == dim)
          parts.names[name] = id;
        else if (dimension + 1 == dim)
          parts.boundaries[name] = id;
      }
    return parts;
  }
} // namespace Structure
