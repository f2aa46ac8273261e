//! The element types of Gmsh and what becomes of them here.

/// The simplex that an element is read as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A point element.
    Vertex,
    /// A line.
    Edge,
    /// A triangle.
    Triangle,
    /// A tetrahedron.
    Tet,
    /// Not a simplex, or of third or higher order: not handled.
    Other,
}

/// One of Gmsh's element types.
#[derive(Debug, PartialEq, Eq)]
pub struct ElementType {
    /// Its number in files.
    pub code: i32,
    /// What several of them are called.
    pub plural: &'static str,
    /// Nodes of one element: its corners first, then those on its edges and inside.
    pub nodes: usize,
    /// What it is read as.
    pub shape: Shape,
}

impl ElementType {
    /// The type of this number, if Gmsh documents one.
    pub fn of(code: i32) -> Option<&'static Self> {
        ALL.iter().find(|kind| kind.code == code)
    }

    /// How many of the nodes are corners, for a simplex.
    pub fn corners(&self) -> usize {
        match self.shape {
            Shape::Vertex => 1,
            Shape::Edge => 2,
            Shape::Triangle => 3,
            Shape::Tet => 4,
            Shape::Other => self.nodes,
        }
    }
}

const fn kind(code: i32, nodes: usize, shape: Shape, plural: &'static str) -> ElementType {
    ElementType { code, plural, nodes, shape }
}

/// Numbers and node counts from the table "MSH file format" of Gmsh's manual.
const ALL: &[ElementType] = &[
    kind(1, 2, Shape::Edge, "lines"),
    kind(2, 3, Shape::Triangle, "triangles"),
    kind(3, 4, Shape::Other, "quadrangles"),
    kind(4, 4, Shape::Tet, "tetrahedra"),
    kind(5, 8, Shape::Other, "hexahedra"),
    kind(6, 6, Shape::Other, "prisms"),
    kind(7, 5, Shape::Other, "pyramids"),
    kind(8, 3, Shape::Edge, "second-order lines"),
    kind(9, 6, Shape::Triangle, "second-order triangles"),
    kind(10, 9, Shape::Other, "nine-node quadrangles"),
    kind(11, 10, Shape::Tet, "second-order tetrahedra"),
    kind(12, 27, Shape::Other, "27-node hexahedra"),
    kind(13, 18, Shape::Other, "18-node prisms"),
    kind(14, 14, Shape::Other, "14-node pyramids"),
    kind(15, 1, Shape::Vertex, "points"),
    kind(16, 8, Shape::Other, "eight-node quadrangles"),
    kind(17, 20, Shape::Other, "20-node hexahedra"),
    kind(18, 15, Shape::Other, "15-node prisms"),
    kind(19, 13, Shape::Other, "13-node pyramids"),
    kind(20, 9, Shape::Other, "nine-node triangles"),
    kind(21, 10, Shape::Other, "third-order triangles"),
    kind(22, 12, Shape::Other, "twelve-node triangles"),
    kind(23, 15, Shape::Other, "fourth-order triangles"),
    kind(24, 15, Shape::Other, "incomplete fifth-order triangles"),
    kind(25, 21, Shape::Other, "fifth-order triangles"),
    kind(26, 4, Shape::Other, "third-order lines"),
    kind(27, 5, Shape::Other, "fourth-order lines"),
    kind(28, 6, Shape::Other, "fifth-order lines"),
    kind(29, 20, Shape::Other, "third-order tetrahedra"),
    kind(30, 35, Shape::Other, "fourth-order tetrahedra"),
    kind(31, 56, Shape::Other, "fifth-order tetrahedra"),
    kind(92, 64, Shape::Other, "64-node hexahedra"),
    kind(93, 125, Shape::Other, "125-node hexahedra"),
];
