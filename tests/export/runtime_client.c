/* What somebody else writes in C99 against the header and libbitrock_runtime.so alone: makes two bits in memory of its
 * own, turns one, takes a step back, and looks whether the force comes back. Exit status 0 when it does. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "runtime/core/bitrock_runtime.h"

#define CHECK(condition)                                                  \
  if (!(condition)) {                                                     \
    fprintf(stderr, "line %d: %s does not hold\n", __LINE__, #condition); \
    return 1;                                                             \
  }

/* One layer from three inputs to the output: weights, then the bias. Here every output is its bias, 1, times its scale.
 */
static const double parameters[4] = {0.0, 0.0, 0.0, 1.0};
static const int32_t layers[2] = {3, 1};
static const double answers[10] = {3e5, 1.1e5, 33, 101, 160, 2e5, 0.8e5, 25, 150, 90};

static bitrock_description describe(const bitrock_cutter* cutters, int64_t count) {
  bitrock_description description;
  int i;
  memset(&description, 0, sizeof description);
  description.signal.window_angle_rad = 1.0471975511965976;
  description.signal.pulse_width_factor = 1.0;
  description.signal.seed = 1;
  description.signal.average_window_s = 0.1;
  for (i = 0; i < 3; ++i) {
    static const double high[3] = {3.0, 4.0, 40.0};
    description.model.inputs[i].high = high[i];
    description.model.inputs[i].scale = 1.0;
  }
  description.model.output_count = 10;
  for (i = 0; i < 10; ++i) {
    description.model.outputs[i].scale = answers[i];
    description.model.outputs[i].parameters = parameters;
    description.model.outputs[i].layers = layers;
    description.model.outputs[i].layer_count = 2;
  }
  description.cutters = cutters;
  description.cutter_count = count;
  return description;
}

int main(void) {
  const bitrock_cutter cutters[2] = {{0.05, 0.05, 0.3, 1}, {0.09, 0.03, 0.35, 2}};
  const bitrock_description description = describe(cutters, 2);
  size_t bytes = 0, state_bytes = 0;
  bitrock_core *core = NULL, *other = NULL;
  bitrock_load load = {0.0, 0.0}, again = {0.0, 0.0};
  double rotation = 0.0, rop = 0.0, sum = 0.0;
  void *memory, *other_memory, *state;
  int i;

  CHECK(bitrock_runtime_version() == BITROCK_RUNTIME_VERSION);
  CHECK(bitrock_core_size(&description, &bytes) == BITROCK_OK);
  memory = malloc(bytes);
  other_memory = malloc(bytes);
  CHECK(memory != NULL && other_memory != NULL);
  CHECK(bitrock_core_create(memory, bytes, &description, &core) == BITROCK_OK);
  CHECK(bitrock_core_create(other_memory, bytes, &description, &other) == BITROCK_OK);
  CHECK(bitrock_core_state_size(core, &state_bytes) == BITROCK_OK);
  state = malloc(state_bytes);
  CHECK(state != NULL);

  for (i = 0; i < 1000; ++i) {
    CHECK(bitrock_core_update(core, 0.01 * i, 6.0, 0.002, &load) == BITROCK_OK);
    CHECK(bitrock_core_accept(core, 0.01 * i / 6.0, 6.0, 0.002) == BITROCK_OK);
    sum += load.torque_N_m;
  }
  CHECK(sum > 0.0 && load.axial_force_N >= 0.0);
  CHECK(bitrock_core_averages(core, &rotation, &rop) == BITROCK_OK);
  CHECK(rotation > 5.999999 && rotation < 6.000001 && rop > 0.001999999 && rop < 0.002000001);

  CHECK(bitrock_core_save(core, state, state_bytes) == BITROCK_OK);
  for (i = 0; i < 100; ++i) CHECK(bitrock_core_update(core, 10.0 + 0.1 * i, 9.0, 0.001, &again) == BITROCK_OK);
  CHECK(bitrock_core_restore(core, state, state_bytes) == BITROCK_OK);
  CHECK(bitrock_core_update(core, 0.01 * 999, 1.0, 0.0, &again) == BITROCK_OK);
  CHECK(memcmp(&load, &again, sizeof load) == 0);
  CHECK(bitrock_core_restore(other, state, state_bytes) == BITROCK_OK);
  CHECK(bitrock_core_update(other, 0.01 * 999, 1.0, 0.0, &again) == BITROCK_OK);
  CHECK(memcmp(&load, &again, sizeof load) == 0);

  CHECK(bitrock_core_update(NULL, 0.0, 6.0, 0.002, &load) == BITROCK_NULL_POINTER);
  CHECK(strlen(bitrock_status_text(BITROCK_NULL_POINTER)) > 0);
  free(state);
  free(other_memory);
  free(memory);
  return 0;
}
