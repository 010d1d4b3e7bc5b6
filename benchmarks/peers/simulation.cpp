// A simple simulation in C++: one trajectory, exact arrival times, Runge-Kutta steps of order 4
// that end at impulses, impacts located by bisection of the step. simulation STEP TIME
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace {

constexpr double kDamping = 0.1, kCubic = 0.1, kIntensity = 0.1, kRestitution = 0.98, kRate = 1;
constexpr double kYMax = 4.2, kVMax = 4.48;
constexpr int kBins = 70;

struct State {
  double y, v;
};

double acceleration(double y, double v) { return -kDamping * v - y - kCubic * y * y * y; }

State runge_kutta_step(State s, double h) {
  const double v1 = s.v, a1 = acceleration(s.y, s.v);
  const double v2 = s.v + h / 2 * a1, a2 = acceleration(s.y + h / 2 * v1, v2);
  const double v3 = s.v + h / 2 * a2, a3 = acceleration(s.y + h / 2 * v2, v3);
  const double v4 = s.v + h * a3, a4 = acceleration(s.y + h * v3, v4);
  return {s.y + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), s.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

// The state at the time h, with impacts.
State advance(State s, double h) {
  while (h > 0) {
    const State end = runge_kutta_step(s, h);
    if (end.y >= 0) return end;
    double low = 0, high = h;
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      (runge_kutta_step(s, middle).y < 0 ? high : low) = middle;
    }
    s = runge_kutta_step(s, high);
    s = {0, -kRestitution * s.v};
    h -= high;
  }
  return s;
}

void print(const char* name, const std::array<double, kBins>& counts, double samples,
           double width) {
  std::printf("%s", name);
  for (const double count : counts) std::printf(",%.17g", count / samples / width);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const double step = std::atof(argv[1]), total = std::atof(argv[2]), burn_in = 100, every = 0.5;
  const std::clock_t begin = std::clock();
  std::mt19937_64 random(1);
  std::exponential_distribution<double> waiting(kRate);
  std::normal_distribution<double> impulse(0, std::sqrt(kIntensity / kRate));
  std::array<double, kBins> y{}, v{};
  State s{0.5, 0};
  double t = 0, next_impulse = waiting(random), next_sample = burn_in, samples = 0;
  while (t < burn_in + total) {
    const double event = std::min(next_impulse, next_sample);
    while (t < event) {
      const double h = std::min(step, event - t);
      s = advance(s, h);
      t = event - t <= step ? event : t + h;
    }
    if (event == next_impulse) {
      s.v += impulse(random);
      next_impulse += waiting(random);
    } else {
      const double row = s.y / kYMax * kBins, column = (s.v + kVMax) / (2 * kVMax) * kBins;
      if (row < kBins) y[static_cast<std::size_t>(row)] += 1;
      if (column >= 0 && column < kBins) v[static_cast<std::size_t>(column)] += 1;
      samples += 1;
      next_sample += every;
    }
  }
  std::printf("seconds,%.6f\n", double(std::clock() - begin) / CLOCKS_PER_SEC);
  print("y", y, samples, kYMax / kBins);
  print("v", v, samples, 2 * kVMax / kBins);
}
