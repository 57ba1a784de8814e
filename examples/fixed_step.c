/* The force on a bit in a loop of fixed steps, in C99: a torsional pendulum (drive, string, bit). The force of your bit
 * and the one line that compiles it, where bitrock is installed in PREFIX:
 *
 *   bitrock export bit campaigns/paper240/model.json campaigns/bits/pdc15.toml -o bit.h
 *   cc -std=c99 fixed_step.c -IPREFIX/include/bitrock -LPREFIX/lib -lbitrock_runtime -Wl,-rpath,PREFIX/lib -lm
 *
 * (or `pkg-config --cflags --libs bitrock_runtime` for all but -lm). bit_force.c takes steps back.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bit.h"
#include "runtime/core/bitrock_runtime.h"

static void check(bitrock_status status) {
  if (status == BITROCK_OK) return;
  fprintf(stderr, "fixed_step: %s\n", bitrock_status_text(status));
  exit(1);
}

int main(void) {
  const double inertia = 40.0, stiffness = 500.0, damping = 30.0; /* [kg m2], [N m/rad], [N m s/rad] */
  const double rock_stiffness = 2e5; /* [N m/rad] of the rock before the cutters: peaks of torque are some mrad wide */
  const double drive = 12.566, rop = 0.004, h = 1e-4; /* [rad/s] 120 rpm, [m/s], [s] */
  double time = 0.0, turned = 0.0, speed = drive;     /* [s], [rad], [rad/s] of the bit */
  double cut = 0.0, twist = 0.0, torque = 0.0;        /* [rad] cut, [rad] of the rock, [N m] on the bit */
  double mean_speed = drive, mean_rop = rop, work = 0.0, push = 0.0, slowest = drive, fastest = drive;
  size_t bytes = 0;
  bitrock_core* core = NULL;
  bitrock_load load = {0.0, 0.0};
  void* memory;
  check(bitrock_core_size(&bit_description, &bytes));
  memory = malloc(bytes);
  check(bitrock_core_create(memory, bytes, &bit_description, &core));

  while (time < 10.0) {
    const double step = h * speed;
    turned += step;
    if (step > 0.0) cut += step; /* never falls: a bit that turned back goes on in fresh rock */
    check(bitrock_core_update(core, cut, mean_speed, mean_rop, &load));
    /* The rock holds like a spring until it breaks at the torque of the cutters; it never pulls the bit along. So a bit
     * that stands or turns back is not turned by a load that is frozen at the angle of its last cut. */
    twist = fmin(fmax(twist + step, 0.0), load.torque_N_m / rock_stiffness);
    torque = rock_stiffness * twist;
    speed += h * (stiffness * (drive * time - turned) + damping * (drive - speed) - torque) / inertia;
    time += h;
    check(bitrock_core_accept(core, time, speed, rop)); /* these two only where speed or rate of penetration swing */
    check(bitrock_core_averages(core, &mean_speed, &mean_rop));
    work += torque * step;
    push += h * load.axial_force_N;
    slowest = fmin(slowest, speed);
    fastest = fmax(fastest, speed);
  }
  printf("bit turned %.1f times, at %.1f to %.1f rpm\n", turned / 6.283185307, slowest * 9.549297, fastest * 9.549297);
  printf("mean torque %.1f N m, mean axial force of the cutters %.2f kN\n", work / turned, 1e-3 * push / time);
  free(memory);
  return 0;
}
