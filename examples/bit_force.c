/* The force on a bit inside the loop of somebody's solver, in C99: a torsional pendulum (drive, string, bit) in steps
 * that choose their own length. bit.h holds the bit and its networks; CMakeLists.txt has it made by
 *
 *   bitrock export bit campaigns/paper240/model.json campaigns/bits/pdc15.toml -o bit.h
 *   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=bit_force && cmake --build build/examples
 *   build/examples/bit_force
 *
 * Prints steps taken and taken back, how the bit turned, the mean load on it, and that load again from a saved state.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bit.h"
#include "runtime/core/bitrock_runtime.h"

static const double inertia = 40.0, stiffness = 500.0, damping = 30.0;   /* [kg m2], [N m/rad], [N m s/rad] */
static const double drive_speed = 12.566, rop = 0.004, tolerance = 1e-4; /* [rad/s] 120 rpm, [m/s], [rad/s] */

static void check(bitrock_status status) {
  if (status == BITROCK_OK) return;
  fprintf(stderr, "bit_force: %s\n", bitrock_status_text(status));
  exit(1);
}

typedef struct {
  double time, angle, speed; /* [s], [rad], [rad/s] of the bit */
} state;

/* [rad/s2] of the bit; the rates that the networks see are means over the last 0.1 s. */
static double acceleration(bitrock_core* core, state s, double mean_speed, double mean_rop, bitrock_load* load) {
  check(bitrock_core_update(core, s.angle, mean_speed, mean_rop, load));
  return (stiffness * (drive_speed * s.time - s.angle) + damping * (drive_speed - s.speed) - load->torque_N_m) /
         inertia;
}

int main(void) {
  size_t bytes = 0, saved_bytes = 0;
  bitrock_core* core = NULL;
  check(bitrock_core_size(&bit_description, &bytes));
  void* memory = malloc(bytes); /* malloc's addresses are divisible by 16 where that is asked for */
  check(bitrock_core_create(memory, bytes, &bit_description, &core));
  check(bitrock_core_state_size(core, &saved_bytes));
  void* saved = malloc(saved_bytes);

  state s = {0.0, 0.0, drive_speed};
  double h = 1e-3, mean_speed = drive_speed, mean_rop = rop, slowest = drive_speed, fastest = drive_speed, work = 0.0;
  bitrock_load load = {0.0, 0.0}, end = {0.0, 0.0};
  int taken = 0, taken_back = 0;
  while (s.time < 10.0) {
    check(bitrock_core_save(core, saved, saved_bytes)); /* so that a step that fails leaves no trace */
    const double a = acceleration(core, s, mean_speed, mean_rop, &load);
    const state next = {s.time + h, s.angle + h * s.speed + 0.5 * h * h * a, s.speed + h * a};
    const double b = acceleration(core, next, mean_speed, mean_rop, &end);
    const double error = 0.5 * h * fabs(b - a); /* Heun's step less Euler's */
    if (error > tolerance && h > 1e-6) {
      check(bitrock_core_restore(core, saved, saved_bytes));
      h *= 0.5;
      ++taken_back;
      continue;
    }
    work += 0.5 * (load.torque_N_m + end.torque_N_m) * (next.angle - s.angle);
    s = next;
    s.speed += 0.5 * h * (b - a);
    check(bitrock_core_accept(core, s.time, s.speed, rop)); /* once, at the end of a step that stays */
    check(bitrock_core_averages(core, &mean_speed, &mean_rop));
    slowest = fmin(slowest, s.speed);
    fastest = fmax(fastest, s.speed);
    h = error < 0.25 * tolerance && h < 1e-3 ? 2.0 * h : h;
    ++taken;
  }
  printf("%d steps, %d taken back\n", taken, taken_back);
  printf("bit turned %.1f times, at %.1f to %.1f rpm\n", s.angle / 6.283185307, slowest * 9.549297, fastest * 9.549297);
  printf("mean torque %.1f N m\n", work / s.angle);
  free(saved);
  free(memory);
  return 0;
}
