//! Kinds of cells: what each family of formats calls them, and what becomes of
//! them here.
//!
//! Corners come first in every family. The order of the nodes behind them
//! differs (VTK and Gmsh swap the last two of a second-order tet), which does not
//! matter as long as these nodes are dropped.

/// A simplex, as the mesh holds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Simplex {
    Vertex,
    Edge,
    Triangle,
    Tet,
}

/// One kind of cells.
#[derive(Debug)]
pub(crate) struct CellKind {
    /// What it is read as; `None` for what is not handled: no simplex, or one of
    /// third or higher order.
    pub(crate) simplex: Option<Simplex>,
    /// Nodes of one cell: its corners first, then those on its edges and inside.
    /// 0 where the number differs from cell to cell.
    pub(crate) nodes: usize,
    vtk: Option<VtkName>,
    gmsh: Option<GmshName>,
    medit: Option<&'static str>,
}

/// VTK's number, and what one cell is called.
#[derive(Debug, Clone, Copy)]
struct VtkName {
    number: u8,
    singular: &'static str,
}

/// Gmsh's number, and what several elements are called.
#[derive(Debug, Clone, Copy)]
struct GmshName {
    code: i32,
    plural: &'static str,
}

impl Simplex {
    /// How many corners it has.
    pub(crate) fn corners(self) -> usize {
        self as usize + 1
    }

    /// The kind of its linear cells.
    fn linear(self) -> &'static CellKind {
        let linear = |kind: &&CellKind| kind.simplex == Some(self) && kind.nodes == self.corners();
        KINDS.iter().find(linear).expect("there are all linear simplices")
    }

    /// VTK's number for its linear cells.
    pub(crate) fn vtk_number(self) -> u8 {
        self.linear().vtk.expect("VTK has all linear simplices").number
    }

    /// Medit's keyword for its linear cells; a vertex has none.
    pub(crate) fn medit_keyword(self) -> Option<&'static str> {
        self.linear().medit
    }
}

impl CellKind {
    /// The kind of VTK's number, if it is known.
    pub(crate) fn of_vtk(number: u8) -> Option<&'static Self> {
        KINDS.iter().find(|kind| kind.vtk.is_some_and(|name| name.number == number))
    }

    /// The kind of Gmsh's element type, if Gmsh documents one.
    pub(crate) fn of_gmsh(code: i32) -> Option<&'static Self> {
        KINDS.iter().find(|kind| kind.gmsh.is_some_and(|name| name.code == code))
    }

    /// The kind of Medit's keyword, in any case, and how Medit spells it.
    pub(crate) fn of_medit(keyword: &str) -> Option<(&'static Self, &'static str)> {
        let spelled = |kind: &'static Self| kind.medit.map(|spelled| (kind, spelled));
        KINDS.iter().filter_map(spelled).find(|(_, spelled)| spelled.eq_ignore_ascii_case(keyword))
    }

    /// Nodes that are no corners, of a kind that is handled.
    pub(crate) fn mid_side<'a>(&self, nodes: &'a [u32]) -> &'a [u32] {
        self.simplex.map_or(&[], |simplex| &nodes[simplex.corners()..])
    }

    /// How a message names one cell of VTK's number.
    pub(crate) fn vtk_name(number: u8) -> String {
        match Self::of_vtk(number).and_then(|kind| kind.vtk) {
            Some(VtkName { singular, .. }) => format!("{singular} (VTK type {number})"),
            None => format!("cell of VTK type {number}"),
        }
    }

    /// How a message names several of Gmsh's elements.
    pub(crate) fn gmsh_name(&self) -> String {
        let (plural, code) = self.gmsh.map_or(("cells", 0), |name| (name.plural, name.code));
        format!("{plural} (element type {code})")
    }

    /// A kind that no format has, yet.
    const fn nodes(nodes: usize) -> Self {
        Self { simplex: None, nodes, vtk: None, gmsh: None, medit: None }
    }

    const fn read_as(mut self, simplex: Simplex) -> Self {
        self.simplex = Some(simplex);
        self
    }

    const fn vtk(mut self, number: u8, singular: &'static str) -> Self {
        self.vtk = Some(VtkName { number, singular });
        self
    }

    const fn gmsh(mut self, code: i32, plural: &'static str) -> Self {
        self.gmsh = Some(GmshName { code, plural });
        self
    }

    const fn medit(mut self, keyword: &'static str) -> Self {
        self.medit = Some(keyword);
        self
    }
}

/// All kinds; those that are handled first, since most cells are of these.
///
/// Numbers and node counts are those of `vtkCellType.h`, of the table "MSH file
/// format" in Gmsh's manual, and of the keywords in the manual of libMeshb.
#[rustfmt::skip]
static KINDS: &[CellKind] = &[
    CellKind::nodes(4).read_as(Simplex::Tet).vtk(10, "tetrahedron").gmsh(4, "tetrahedra").medit("Tetrahedra"),
    CellKind::nodes(3).read_as(Simplex::Triangle).vtk(5, "triangle").gmsh(2, "triangles").medit("Triangles"),
    CellKind::nodes(2).read_as(Simplex::Edge).vtk(3, "line").gmsh(1, "lines").medit("Edges"),
    CellKind::nodes(1).read_as(Simplex::Vertex).vtk(1, "vertex").gmsh(15, "points"),
    CellKind::nodes(10).read_as(Simplex::Tet).vtk(24, "quadratic tetrahedron").gmsh(11, "second-order tetrahedra").medit("TetrahedraP2"),
    CellKind::nodes(6).read_as(Simplex::Triangle).vtk(22, "quadratic triangle").gmsh(9, "second-order triangles").medit("TrianglesP2"),
    CellKind::nodes(3).read_as(Simplex::Edge).vtk(21, "quadratic line").gmsh(8, "second-order lines").medit("EdgesP2"),
    // Linear cells of other shapes.
    CellKind::nodes(4).vtk(9, "quadrilateral").gmsh(3, "quadrangles").medit("Quadrilaterals"),
    CellKind::nodes(8).vtk(12, "hexahedron").gmsh(5, "hexahedra").medit("Hexahedra"),
    CellKind::nodes(6).vtk(13, "wedge").gmsh(6, "prisms").medit("Prisms"),
    CellKind::nodes(5).vtk(14, "pyramid").gmsh(7, "pyramids").medit("Pyramids"),
    CellKind::nodes(0).vtk(0, "empty cell"),
    CellKind::nodes(0).vtk(2, "poly-vertex"),
    CellKind::nodes(0).vtk(4, "poly-line"),
    CellKind::nodes(0).vtk(6, "triangle strip"),
    CellKind::nodes(0).vtk(7, "polygon"),
    CellKind::nodes(4).vtk(8, "pixel"),
    CellKind::nodes(8).vtk(11, "voxel"),
    CellKind::nodes(0).vtk(41, "convex point set"),
    CellKind::nodes(0).vtk(42, "polyhedron"),
    // Second order, with and without nodes inside.
    CellKind::nodes(8).vtk(23, "quadratic quadrilateral").gmsh(16, "eight-node quadrangles"),
    CellKind::nodes(20).vtk(25, "quadratic hexahedron").gmsh(17, "20-node hexahedra"),
    CellKind::nodes(15).vtk(26, "quadratic wedge").gmsh(18, "15-node prisms"),
    CellKind::nodes(13).vtk(27, "quadratic pyramid").gmsh(19, "13-node pyramids"),
    CellKind::nodes(9).gmsh(10, "nine-node quadrangles").medit("QuadrilateralsQ2"),
    CellKind::nodes(27).gmsh(12, "27-node hexahedra").medit("HexahedraQ2"),
    CellKind::nodes(18).gmsh(13, "18-node prisms").medit("PrismsP2"),
    CellKind::nodes(14).gmsh(14, "14-node pyramids").medit("PyramidsP2"),
    // Higher order.
    CellKind::nodes(4).gmsh(26, "third-order lines").medit("EdgesP3"),
    CellKind::nodes(5).gmsh(27, "fourth-order lines").medit("EdgesP4"),
    CellKind::nodes(6).gmsh(28, "fifth-order lines"),
    CellKind::nodes(9).gmsh(20, "nine-node triangles"),
    CellKind::nodes(10).gmsh(21, "third-order triangles").medit("TrianglesP3"),
    CellKind::nodes(12).gmsh(22, "twelve-node triangles"),
    CellKind::nodes(15).gmsh(23, "fourth-order triangles").medit("TrianglesP4"),
    CellKind::nodes(15).gmsh(24, "incomplete fifth-order triangles"),
    CellKind::nodes(21).gmsh(25, "fifth-order triangles"),
    CellKind::nodes(16).medit("QuadrilateralsQ3"),
    CellKind::nodes(25).medit("QuadrilateralsQ4"),
    CellKind::nodes(20).gmsh(29, "third-order tetrahedra").medit("TetrahedraP3"),
    CellKind::nodes(35).gmsh(30, "fourth-order tetrahedra").medit("TetrahedraP4"),
    CellKind::nodes(56).gmsh(31, "fifth-order tetrahedra"),
    CellKind::nodes(64).gmsh(92, "64-node hexahedra").medit("HexahedraQ3"),
    CellKind::nodes(125).gmsh(93, "125-node hexahedra").medit("HexahedraQ4"),
    CellKind::nodes(40).medit("PrismsP3"),
    CellKind::nodes(75).medit("PrismsP4"),
    CellKind::nodes(30).medit("PyramidsP3"),
    CellKind::nodes(55).medit("PyramidsP4"),
];
