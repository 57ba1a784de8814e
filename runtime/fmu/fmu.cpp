// The 34 functions of FMI 2.0 for co-simulation, on what an FMU holds (slave.hpp). They look at pointers, phases and
// value references, and say what went wrong in words. A call that answers fmi2Error has changed nothing, so the
// importer may go on, unless a step broke a string; no call answers fmi2Fatal. Memory comes from malloc; nothing is
// kept outside of the instances.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "runtime/fmu/fmi2.hpp"
#include "runtime/fmu/resource.hpp"
#include "runtime/fmu/slave.hpp"

using namespace bitrock;

#ifdef _WIN32
#define FMI2_FUNCTION extern "C" __declspec(dllexport)
#else
#define FMI2_FUNCTION extern "C" __attribute__((visibility("default")))
#endif

namespace {

using fmu::Causality, fmu::Clock, fmu::Phase, fmu::Type, fmu::Variable;

struct Instance {
  fmu::Slave* slave = nullptr;
  fmi2CallbackFunctions callbacks{};
  char* name = nullptr;
};

/// A saved state: its size, then the bytes.
struct SavedState {
  std::size_t size;
  char* bytes() { return reinterpret_cast<char*>(this + 1); }
};

Instance* at(fmi2Component component) {
  return static_cast<Instance*>(component);
}

void log(const fmi2CallbackFunctions& callbacks, const char* name, const char* function, const char* reason) {
  if (callbacks.logger == nullptr) return;
  char text[fmu::longest_path + 512], message[2 * sizeof(text)];
  std::snprintf(text, sizeof(text), "%s: %s", function, reason);
  // The message is a format, but importers without variable arguments show it as it is: so it is the whole text, with
  // each sign of percent (a path may hold some) written twice.
  char* end = message;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c == '%') *end++ = '%';
    *end++ = *c;
  }
  *end = '\0';
  callbacks.logger(callbacks.componentEnvironment, name, fmi2Error, "logStatusError", message);
}

fmi2Status fail(const Instance* instance, const char* function, const char* reason) {
  log(instance->callbacks, instance->name, function, reason);
  return fmi2Error;
}

fmi2Status answer(const Instance* instance, const char* function, const char* reason) {
  return reason == nullptr ? fmi2OK : fail(instance, function, reason);
}

Clock& clock_of(Instance* instance) {
  return fmu::clock_of(*instance->slave);
}

const Clock& clock_of(const Instance* instance) {
  return fmu::clock_of(*instance->slave);
}

fmi2Status fail_variable(const Instance* instance, const char* function, unsigned reference, const char* reason) {
  char text[256];
  const Variable* const variable = variable_at(*instance->slave, reference);
  std::snprintf(text, sizeof(text), "value reference %u, %s: %s", reference,
                variable == nullptr ? "(no such variable)" : variable->name, reason);
  return fail(instance, function, text);
}

/// Null: there is none of that number and kind.
const Variable* typed_variable(const Instance* instance, unsigned reference, bool real) {
  const Variable* const variable = variable_at(*instance->slave, reference);
  return variable != nullptr && (variable->type == Type::real) == real ? variable : nullptr;
}

/// Why this variable cannot be set to this value now; null when it can.
template <class Value>
const char* objection(const Instance* instance, const Variable& variable, Value value) {
  const Phase phase = clock_of(instance).phase;
  if (variable.causality == Causality::output) return "an output cannot be set";
  if (phase == Phase::terminated) return "the simulation has ended";
  if (variable.causality == Causality::parameter && phase == Phase::stepping)
    return "a parameter is fixed once the initialisation is over";
  if (!std::isfinite(static_cast<double>(value))) return "the value must be finite";
  if (variable.type == Type::integer && value < 0) return "the value must be 0 or more";
  return nullptr;
}

/// All of them, or none.
template <class Value>
fmi2Status set(Instance* instance, const char* function, const unsigned* references, std::size_t count,
               const Value* values) {
  constexpr bool real = sizeof(Value) == sizeof(double);
  if (count > 0 && (references == nullptr || values == nullptr)) return fail(instance, function, "a null pointer");
  for (std::size_t i = 0; i < count; ++i) {
    const Variable* const variable = typed_variable(instance, references[i], real);
    if (variable == nullptr) return fail_variable(instance, function, references[i], "not a variable of this type");
    if (const char* const reason = objection(instance, *variable, values[i]); reason != nullptr)
      return fail_variable(instance, function, references[i], reason);
  }
  if (const char* const reason = set_values(*instance->slave, references, count, values); reason != nullptr)
    return fail(instance, function, reason);
  if (clock_of(instance).phase != Phase::stepping) clock_of(instance).stale = 1;
  return fmi2OK;
}

template <class Value>
fmi2Status get(Instance* instance, const char* function, const unsigned* references, std::size_t count, Value* values) {
  constexpr bool real = sizeof(Value) == sizeof(double);
  if (count > 0 && (references == nullptr || values == nullptr)) return fail(instance, function, "a null pointer");
  if (clock_of(instance).phase == Phase::initialising) {
    if (const char* const reason = find_start(*instance->slave); reason != nullptr)
      return fail(instance, function, reason);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned reference = references[i];
    if (typed_variable(instance, reference, real) == nullptr)
      return fail_variable(instance, function, reference, "not a variable of this type");
    if constexpr (real)
      values[i] = real_value(*instance->slave, reference);
    else
      values[i] = integer_value(*instance->slave, reference);
  }
  return fmi2OK;
}

/// For types of which there are no variables.
fmi2Status none(fmi2Component component, const char* function, std::size_t count) {
  if (component == nullptr) return fmi2Error;
  return count == 0 ? fmi2OK : fail(at(component), function, "there are no variables of this type");
}

/// Into the next phase, from the one before it.
fmi2Status enter(Instance* instance, const char* function, Phase from, Phase to) {
  if (clock_of(instance).phase != from) return fail(instance, function, "not allowed in this phase");
  clock_of(instance).phase = to;
  return fmi2OK;
}

/// Equal but for the rounding of an importer that counts time in its own way.
bool same_time(double a, double b, double step) {
  return std::fabs(a - b) <= 1e-9 * (std::fabs(b) + step);
}

/// Why no step can be made from `begin` over `size`; null when one can.
const char* step_objection(const Clock& clock, double begin, double size) {
  if (clock.phase == Phase::broken)
    return "a step before this one failed half-way: reset, or set a state from before it";
  if (clock.phase != Phase::stepping) return "not allowed in this phase";
  if (!std::isfinite(begin) || !std::isfinite(size)) return "the time or the step is not finite";
  if (!(size > 0.0)) return "the step must be above 0";
  if (!same_time(begin, clock.time, size)) return "the step must begin where the one before ended";
  const double end = begin + size;
  if (!std::isfinite(end) || !(end > clock.time)) return "the step is too short for this time";
  if (end > clock.stop_time && !same_time(end, clock.stop_time, size)) return "the step ends after the stop time";
  return nullptr;
}

const char* copied(const char* text, char*& copy) {
  const std::size_t size = std::strlen(text) + 1;
  copy = static_cast<char*>(std::malloc(size));
  return copy == nullptr ? nullptr : static_cast<const char*>(std::memcpy(copy, text, size));
}

/// Reads the resource into the instance; null, or the reason, for which `room` may be used.
const char* load(Instance& instance, const char* guid, const char* location, char (&room)[fmu::longest_path + 256]) {
  char path[fmu::longest_path];
  if (!fmu::resource_path(location, fmu::resource_name(), path)) {
    std::snprintf(room, sizeof(room), "'%.1000s' (the resource location must be a URI of a local file)", location);
    return room;
  }
  const fmu::FileBytes file = fmu::read_file(path, fmu::most_resource_bytes);
  if (file.bytes == nullptr) {
    std::snprintf(room, sizeof(room), "'%s' cannot be read", path);
    return room;
  }
  const char* reason = nullptr;
  instance.slave = fmu::make(file.bytes, file.size, reason);
  if (instance.slave == nullptr) {
    std::snprintf(room, sizeof(room), "'%s': %s", path, reason);
    return room;
  }
  const char* const own = guid_of(*instance.slave);
  if (std::strcmp(guid, own) == 0) return nullptr;
  std::snprintf(room, sizeof(room),
                "guid '%.100s' (this FMU has '%s': model description and resources do not belong "
                "together)",
                guid, own);
  return room;
}

}  // namespace

FMI2_FUNCTION const char* fmi2GetTypesPlatform() {
  return "default";
}

FMI2_FUNCTION const char* fmi2GetVersion() {
  return "2.0";
}

/// Errors are always told; there is nothing else to tell.
FMI2_FUNCTION fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, size_t, const fmi2String*) {
  return component == nullptr ? fmi2Error : fmi2OK;
}

FMI2_FUNCTION void fmi2FreeInstance(fmi2Component component) {
  if (component == nullptr) return;
  fmu::destroy(at(component)->slave);
  std::free(at(component)->name);
  std::free(component);
}

FMI2_FUNCTION fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String location,
                                            const fmi2CallbackFunctions* callbacks, fmi2Boolean, fmi2Boolean) {
  if (callbacks == nullptr) return nullptr;
  const char* const function = "fmi2Instantiate";
  const char* reason = nullptr;
  if (name == nullptr || *name == '\0') reason = "the instance has no name";
  if (type != fmi2CoSimulation) reason = "only co-simulation";
  if (guid == nullptr) reason = "no guid";
  if (location == nullptr) reason = "no resource location";
  if (reason != nullptr) {
    log(*callbacks, name == nullptr ? "" : name, function, reason);
    return nullptr;
  }
  void* const memory = std::malloc(sizeof(Instance));
  if (memory == nullptr) return nullptr;
  Instance* const instance = new (memory) Instance;
  instance->callbacks = *callbacks;
  char room[fmu::longest_path + 256];
  reason = copied(name, instance->name) == nullptr ? "no memory" : load(*instance, guid, location, room);
  if (reason == nullptr) return instance;
  log(*callbacks, name, function, reason);
  fmi2FreeInstance(instance);
  return nullptr;
}

FMI2_FUNCTION fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start,
                                             fmi2Boolean stop_defined, fmi2Real stop) {
  if (component == nullptr) return fmi2Error;
  Clock& clock = clock_of(at(component));
  if (clock.phase != Phase::instantiated)
    return fail(at(component), "fmi2SetupExperiment", "not allowed in this phase");
  if (!std::isfinite(start) || (stop_defined != fmi2False && !(stop > start)))
    return fail(at(component), "fmi2SetupExperiment", "the start must be finite and before the stop");
  clock.time = start;
  clock.stop_time = stop_defined != fmi2False ? stop : Clock{}.stop_time;
  clock.stale = 1;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  if (component == nullptr) return fmi2Error;
  return enter(at(component), "fmi2EnterInitializationMode", Phase::instantiated, Phase::initialising);
}

FMI2_FUNCTION fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  if (component == nullptr) return fmi2Error;
  const char* const function = "fmi2ExitInitializationMode";
  Instance* const instance = at(component);
  if (clock_of(instance).phase != Phase::initialising) return fail(instance, function, "not allowed in this phase");
  if (const char* const reason = find_start(*instance->slave); reason != nullptr)
    return fail(instance, function, reason);
  return enter(instance, function, Phase::initialising, Phase::stepping);
}

FMI2_FUNCTION fmi2Status fmi2Terminate(fmi2Component component) {
  if (component == nullptr) return fmi2Error;
  return enter(at(component), "fmi2Terminate", Phase::stepping, Phase::terminated);
}

FMI2_FUNCTION fmi2Status fmi2Reset(fmi2Component component) {
  if (component == nullptr) return fmi2Error;
  begin_again(*at(component)->slave);
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                     fmi2Real values[]) {
  return component == nullptr ? fmi2Error : get(at(component), "fmi2GetReal", references, count, values);
}

FMI2_FUNCTION fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                        fmi2Integer values[]) {
  return component == nullptr ? fmi2Error : get(at(component), "fmi2GetInteger", references, count, values);
}

FMI2_FUNCTION fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference[], size_t count,
                                        fmi2Boolean[]) {
  return none(component, "fmi2GetBoolean", count);
}

FMI2_FUNCTION fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference[], size_t count,
                                       fmi2String[]) {
  return none(component, "fmi2GetString", count);
}

FMI2_FUNCTION fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                     const fmi2Real values[]) {
  return component == nullptr ? fmi2Error : set(at(component), "fmi2SetReal", references, count, values);
}

FMI2_FUNCTION fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer values[]) {
  return component == nullptr ? fmi2Error : set(at(component), "fmi2SetInteger", references, count, values);
}

FMI2_FUNCTION fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference[], size_t count,
                                        const fmi2Boolean[]) {
  return none(component, "fmi2SetBoolean", count);
}

FMI2_FUNCTION fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference[], size_t count,
                                       const fmi2String[]) {
  return none(component, "fmi2SetString", count);
}

FMI2_FUNCTION fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  if (component == nullptr || state == nullptr) return fmi2Error;
  const fmu::Slave& slave = *at(component)->slave;
  const std::size_t size = state_bytes(slave);
  SavedState* saved = static_cast<SavedState*>(*state);
  if (saved == nullptr || saved->size != size) {
    saved = static_cast<SavedState*>(std::realloc(saved, sizeof(SavedState) + size));
    if (saved == nullptr) return fail(at(component), "fmi2GetFMUstate", "no memory");
    std::memset(saved->bytes(), 0, size);  // a core says nothing of the bytes it does not use
    saved->size = size;
    *state = saved;
  }
  save(slave, saved->bytes());
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  if (component == nullptr) return fmi2Error;
  if (state == nullptr) return fail(at(component), "fmi2SetFMUstate", "no state");
  SavedState* const saved = static_cast<SavedState*>(state);
  return answer(at(component), "fmi2SetFMUstate", restore(*at(component)->slave, saved->bytes(), saved->size));
}

FMI2_FUNCTION fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  if (component == nullptr) return fmi2Error;
  if (state == nullptr) return fmi2OK;
  std::free(*state);
  *state = nullptr;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t* size) {
  if (component == nullptr) return fmi2Error;
  if (state == nullptr || size == nullptr) return fail(at(component), "fmi2SerializedFMUstateSize", "a null pointer");
  *size = static_cast<SavedState*>(state)->size;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[],
                                               size_t size) {
  if (component == nullptr) return fmi2Error;
  SavedState* const saved = static_cast<SavedState*>(state);
  if (saved == nullptr || bytes == nullptr || size < saved->size)
    return fail(at(component), "fmi2SerializeFMUstate", "a null pointer, or too few bytes");
  std::memcpy(bytes, saved->bytes(), saved->size);
  return fmi2OK;
}

/// Whether the bytes are of this FMU, and whole, is found when the state is set.
FMI2_FUNCTION fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                                 fmi2FMUstate* state) {
  if (component == nullptr) return fmi2Error;
  const char* const function = "fmi2DeSerializeFMUstate";
  if (bytes == nullptr || state == nullptr) return fail(at(component), function, "a null pointer");
  if (size != state_bytes(*at(component)->slave)) return fail(at(component), function, "the state is of another size");
  SavedState* const saved = static_cast<SavedState*>(std::realloc(*state, sizeof(SavedState) + size));
  if (saved == nullptr) return fail(at(component), function, "no memory");
  saved->size = size;
  std::memcpy(saved->bytes(), bytes, size);
  *state = saved;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference[], size_t,
                                                      const fmi2ValueReference[], size_t, const fmi2Real[],
                                                      fmi2Real[]) {
  return component == nullptr ? fmi2Error : fail(at(component), "fmi2GetDirectionalDerivative", "not provided");
}

FMI2_FUNCTION fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference[], size_t count,
                                                     const fmi2Integer[], const fmi2Real[]) {
  return none(component, "fmi2SetRealInputDerivatives", count);
}

FMI2_FUNCTION fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference[], size_t count,
                                                      const fmi2Integer[], fmi2Real[]) {
  return none(component, "fmi2GetRealOutputDerivatives", count);
}

FMI2_FUNCTION fmi2Status fmi2DoStep(fmi2Component component, fmi2Real begin, fmi2Real size, fmi2Boolean) {
  if (component == nullptr) return fmi2Error;
  Instance* const instance = at(component);
  if (const char* const reason = step_objection(clock_of(instance), begin, size); reason != nullptr)
    return fail(instance, "fmi2DoStep", reason);
  return answer(instance, "fmi2DoStep", step(*instance->slave, begin + size));
}

FMI2_FUNCTION fmi2Status fmi2CancelStep(fmi2Component component) {
  return component == nullptr ? fmi2Error : fail(at(component), "fmi2CancelStep", "no step is pending");
}

// Steps are never pending: what is asked about them is discarded, as the standard says.

FMI2_FUNCTION fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind, fmi2Status*) {
  return component == nullptr ? fmi2Error : fmi2Discard;
}

FMI2_FUNCTION fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real* value) {
  if (component == nullptr || value == nullptr) return fmi2Error;
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  *value = clock_of(at(component)).time;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind, fmi2Integer*) {
  return component == nullptr ? fmi2Error : fmi2Discard;
}

FMI2_FUNCTION fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean* value) {
  if (component == nullptr || value == nullptr) return fmi2Error;
  if (kind != fmi2Terminated) return fmi2Discard;
  *value = fmi2False;
  return fmi2OK;
}

FMI2_FUNCTION fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind, fmi2String*) {
  return component == nullptr ? fmi2Error : fmi2Discard;
}
