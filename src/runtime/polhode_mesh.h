/* polhode_mesh.h - bodies from mesh files; polhode.h includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   ph_body, ph_amount and the statuses are those of polhode.h. */
#ifndef POLHODE_MESH_H
#define POLHODE_MESH_H

#ifdef __cplusplus
extern "C" {
#endif

/* What is wrong with a closed part of a volume where it lies. */
typedef enum ph_mesh_fault_kind {
  PH_MESH_INWARD,  /* looks inward, and lies in no other part: it was turned */
  PH_MESH_OUTWARD, /* looks outward inside of another part: it was turned, and is a cavity */
  PH_MESH_SOLID,   /* looks inward inside of a cavity: it was turned, and is matter */
  PH_MESH_OVERLAP  /* two parts cross each other: what both hold counts twice */
} ph_mesh_fault_kind;

typedef struct ph_mesh_fault {
  ph_mesh_fault_kind kind;
  size_t part, other; /* from 1, in the order of the file; other: the part around, or the second */
  size_t triangles;   /* of the part */
  double at[3];       /* middle of the part's box; of an overlap: a point in both */
  double share;       /* of an overlap: its volume, to a few percent of the smaller box */
} ph_mesh_fault;

enum { PH_MESH_FAULTS = 8 };

typedef enum ph_mesh_kind {
  PH_MESH_VOLUME,  /* the solid that the faces enclose */
  PH_MESH_SURFACE, /* the faces, uniform areal density */
  PH_MESH_WIRES    /* each distinct edge of a face and each segment of the file once */
} ph_mesh_kind;

/* What a file holds, in its own unit of length and per unit density. Vertices are welded where all
   three coordinates are equal; only those that a face or segment uses count. */
typedef struct ph_mesh {
  ph_mesh_kind kind;
  double measure;             /* volume, area or length; 0: see ph_mesh_check */
  double com[3], com_tail[3]; /* centre, as in ph_body */
  double sigma[6];            /* second moments about it per unit measure: xx yy zz xy xz yz */
  double lo[3], hi[3];        /* bounding box */
  size_t faces, triangles;    /* as read; after polygons were fanned */
  size_t vertices, edges;     /* distinct; edges of faces */
  size_t segments;            /* of OBJ lines and PLY edges */
  size_t open;                /* edges of one face */
  size_t flipped;             /* edges of two faces that run along it in the same direction */
  size_t nonmanifold;         /* edges of more than two faces */
  size_t unbalanced;          /* edges not run along as often one way as the other: 0 = closed */
  size_t duplicate;           /* triangles that repeat the corners of another */
  size_t degenerate;          /* faces without area */
  size_t nonfinite;           /* faces and segments left out: a coordinate is not finite */
  int inverted;               /* the faces look inward: volume and moments were negated */
  size_t bent;                /* polygons that are not flat */
  double bend;                /* by how much the measure may change by their other diagonals */
  double weld; /* volume: that vertices were welded by, or would have to be to close it; in parts of
                  the box's longest side; 0: none */
  size_t merged; /* vertices that this took away */
  double gap;    /* the farthest that a vertex was moved by it */
  size_t parts;  /* closed parts of a volume */
  size_t faults; /* parts that lie wrong and pairs that overlap; the first few: */
  ph_mesh_fault fault[PH_MESH_FAULTS];
  int unseen; /* not all pairs of parts were looked at: there are too many */
} ph_mesh;

/* Read STL (text or binary), OBJ or PLY (text or binary, either byte order); a byte-order
   mark of UTF-8 is passed over. The name's ending
   .stl, .obj, .ply decides, any other the content. STL is binary if its size is what the count at
   byte 80 says, text if it begins with "solid" and has no control characters in its first 1024
   bytes. Numbers are read to the nearest double. Volumes are sums of tetrahedra from a vertex of
   the mesh (divergence theorem), formed in long double and added with compensation. A polygon is
   the fan of triangles from its first corner: exact for plane polygons, convex or not (in a
   surface, a triangle that looks against the polygon's vector area is subtracted); a polygon that
   is not plane means that fan. Its diagonals are no edges. A volume needs closed faces: else, and
   when what was asked for is 0, *out has its counts and measure, com and sigma are 0. PH_ENAME (no
   such kind), PH_EFILE, PH_EFORMAT, PH_ERANGE, PH_EMEMORY; then message (NULL allowed) has at most
   size bytes of text with the line or byte, without the file's name, and *out is untouched. */
int ph_mesh_read(ph_mesh *out, const char *path, ph_mesh_kind kind, char *message, size_t size);
/* The same with vertices welded that are nearer than `weld` (0 to 0.01; 0: equal) times the longest
   side of the box. shape: NULL, or receives the faces, to ask about points; ph_mesh_close frees it.
   Also PH_EBOUND. */
typedef struct ph_mesh_shape ph_mesh_shape;
int ph_mesh_open(ph_mesh *out, ph_mesh_shape **shape, const char *path, ph_mesh_kind kind,
                 double weld, char *message, size_t size);
void ph_mesh_close(ph_mesh_shape *shape);
/* How far p is from the faces (of wires, from the edges); of a volume negative inside. NaN: out of
   memory. */
double ph_mesh_excess(ph_mesh_shape *shape, const double p[3]);
/* How many triangles (of wires: edges, whose last two corners are one), and the corners of one. */
size_t ph_mesh_count(const ph_mesh_shape *shape);
int ph_mesh_triangle(const ph_mesh_shape *shape, size_t i, double corner[9]);
/* Can it be a body? PH_EFINITE: coordinates that are not finite; PH_EOPEN: a volume with unbalanced
   edges; PH_EEMPTY: measure 0. */
int ph_mesh_check(const ph_mesh *mesh);
/* The body, where the file's unit of length is `unit` metres. Also PH_ELENGTH, PH_EMASS, PH_ERANGE
   and the refusals of ph_body_check. */
int ph_mesh_body(ph_body *b, ph_amount a, const ph_mesh *mesh, double unit);

#ifdef __cplusplus
}
#endif

#endif
