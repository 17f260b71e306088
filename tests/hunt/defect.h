static void planted(const double *g, double x[7]) { (void)g; (void)x; }
