// plane_simbody.cpp - the peer of plane.c: the same ball in Simbody (Debian's libsimbody-dev), make bench-plane.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// plane_simbody TRUTH SECONDS: a free body with a SphereOnPlaneContact that enforces rolling; its Runge-Kutta-Merson at
// the accuracy that ends nearest to the error of the emitted code's run.
#include <Simbody.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace SimTK;

static double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

static double median(std::vector<double> list) {
  std::sort(list.begin(), list.end());
  return list[list.size() / 2];
}

int main(int argc, char **argv) {
  if (argc < 3)
    return 1;
  const double span = std::atof(argv[2]), radius = 0.06;
  double truth[9];
  std::FILE *file = std::fopen(argv[1], "r");
  for (double &x : truth)
    if (!file || std::fscanf(file, "%lf", &x) != 1)
      return 1;
  std::fclose(file);
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  GeneralForceSubsystem forces(system);
  Force::Gravity gravity(forces, matter, -ZAxis, 9.80665);
  MobilizedBody::Free ball(matter.Ground(),
                           Body::Rigid(MassProperties(1.5, Vec3(0), Inertia(0.0012, 0.0018, 0.0024))));
  // the plane's own z is its normal
  Constraint::SphereOnPlaneContact contact(matter.Ground(), Transform(), ball, Vec3(0), radius, true);
  State state = system.realizeTopology();
  system.realizeModel(state);
  ball.setQToFitTransform(state, Transform(Vec3(0, 0, radius)));
  const Vec3 w(4, -3, 9);
  ball.setUToFitVelocity(state, SpatialVec(w, cross(w, Vec3(0, 0, radius))));
  system.realize(state, Stage::Acceleration);
  std::vector<double> rates, runs;
  const int calls = 20000;
  double sum = 0;
  for (int r = 0; r < 11; r++) {
    const double t = now();
    for (int k = 0; k < calls; k++) {
      state.updU()[0] += 1e-12;
      system.realize(state, Stage::Acceleration);
      sum += state.getUDot()[1];
    }
    rates.push_back((now() - t) / calls);
  }
  ball.setUToFitVelocity(state, SpatialVec(w, cross(w, Vec3(0, 0, radius))));
  double error = 0;
  for (int r = 0; r < 11; r++) {
    RungeKuttaMersonIntegrator integrator(system);
    integrator.setAccuracy(1e-9);
    const double t = now();
    TimeStepper stepper(system, integrator);
    stepper.initialize(state);
    stepper.stepTo(span);
    runs.push_back(now() - t);
    system.realize(integrator.getState(), Stage::Velocity);
    const State &end = integrator.getState();
    const Vec3 in_body = ~ball.getBodyTransform(end).R() * ball.getBodyVelocity(end)[0];
    error = 0;
    for (int i = 0; i < 3; i++)
      error = std::max(error, std::abs(in_body[i] - truth[4 + i]));
  }
  std::printf("%-40s %12.4g %12.4g %12.2g\n", "Simbody, Runge-Kutta-Merson", median(rates) * 1e9, median(runs) * 1e3,
              error);
  return sum == 0.5;
}
