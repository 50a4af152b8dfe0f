// Exact shortest paths on triangle meshes of the saddle z = x^2 - y^2, by CGAL (Xin and Wang's algorithm). A grid of N x N cells is meshed once;
// each pair gets a sequence tree from its first point, and a query for its second one.
//
//   mesh N ROUNDS < pairs       a count, then u v u v of each. Prints JSON: the seconds of the mesh, and of each pair its length and least seconds.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_shortest_path<Traits>;

static const double HALF_U = 1, HALF_V = std::acos(-1.0) / 3;

static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

static Mesh make_saddle(int n) {
    Mesh mesh;
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++) {
            double u = HALF_U * (2.0 * i / n - 1), v = HALF_V * (2.0 * j / n - 1);
            mesh.add_vertex(Kernel::Point_3(u, v, u * u - v * v));
        }
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            Mesh::Vertex_index a(j * (n + 1) + i), b(a + 1), c(a + n + 2), d(a + n + 1);
            mesh.add_face(a, b, c), mesh.add_face(a, c, d);
        }
    return mesh;
}

// Where u, v lies on the mesh: the parameters are the x and y of its vertices. Faces are numbered by cells, two in each.
static Paths::Face_location locate(const Mesh &mesh, int n, double u, double v) {
    double s = (u / HALF_U + 1) * n / 2, t = (v / HALF_V + 1) * n / 2;
    int i = std::min((int)s, n - 1), j = std::min((int)t, n - 1);
    Mesh::Face_index face(2 * (j * n + i) + (s - i < t - j ? 1 : 0));
    Mesh::Halfedge_index h = mesh.halfedge(face);
    Kernel::Point_3 p[3] = {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
    auto area = [](double x1, double y1, double x2, double y2) { return x1 * y2 - x2 * y1; };
    double whole = area(p[1].x() - p[0].x(), p[1].y() - p[0].y(), p[2].x() - p[0].x(), p[2].y() - p[0].y());
    double b = area(u - p[0].x(), v - p[0].y(), p[2].x() - p[0].x(), p[2].y() - p[0].y()) / whole;
    double c = area(p[1].x() - p[0].x(), p[1].y() - p[0].y(), u - p[0].x(), v - p[0].y()) / whole;
    return {face, {1 - b - c, b, c}};
}

int main(int count, char **arguments) {
    if (count != 3) return 2;
    int n = atoi(arguments[1]), rounds = atoi(arguments[2]), pairs = 0;
    if (scanf("%d", &pairs) != 1) return 4;
    double start = seconds();
    Mesh mesh = make_saddle(n);
    printf("{\"mesh\": %.9g, \"pairs\": [", seconds() - start);
    for (int k = 0; k < pairs; k++) {
        double u[4], least = INFINITY, length = NAN;
        if (scanf("%lf %lf %lf %lf", u, u + 1, u + 2, u + 3) != 4) return 4;
        auto from = locate(mesh, n, u[0], u[1]), to = locate(mesh, n, u[2], u[3]);
        for (int i = 0; i < rounds; i++) {
            start = seconds();
            Paths paths(mesh);
            paths.add_source_point(from.first, from.second);
            length = paths.shortest_distance_to_source_points(to.first, to.second).first;
            least = std::min(least, seconds() - start);
        }
        printf("%s{\"length\": %.17g, \"seconds\": %.9g}", k ? ", " : "", length, least);
    }
    printf("]}\n");
    return 0;
}
