#pragma once
/// A small importer of FMUs for co-simulation (FMI 2.0), as somebody else would write it from the standard: nothing of
/// bitrock is in it, not even its declarations of the interface. Loads the library of an unpacked FMU, on Linux or (by
/// a compiler for it) on Windows.

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace importer {

using Component = void*;
using State = void*;
enum Status { ok, warning, discard, error, fatal, pending };

struct Callbacks {
  void (*logger)(void*, const char*, int, const char*, const char*, ...);
  void* (*allocate)(std::size_t, std::size_t);
  void (*free)(void*);
  void (*step_finished)(void*, int);
  void* environment;
};

/// The 34 functions; those that are called here with their types.
struct Library {
  const char* (*fmi2GetTypesPlatform)();
  const char* (*fmi2GetVersion)();
  int (*fmi2SetDebugLogging)(Component, int, std::size_t, const char* const*);
  Component (*fmi2Instantiate)(const char*, int, const char*, const char*, const Callbacks*, int, int);
  void (*fmi2FreeInstance)(Component);
  int (*fmi2SetupExperiment)(Component, int, double, double, int, double);
  int (*fmi2EnterInitializationMode)(Component);
  int (*fmi2ExitInitializationMode)(Component);
  int (*fmi2Terminate)(Component);
  int (*fmi2Reset)(Component);
  int (*fmi2GetReal)(Component, const unsigned*, std::size_t, double*);
  int (*fmi2GetInteger)(Component, const unsigned*, std::size_t, int*);
  int (*fmi2GetBoolean)(Component, const unsigned*, std::size_t, int*);
  int (*fmi2GetString)(Component, const unsigned*, std::size_t, const char**);
  int (*fmi2SetReal)(Component, const unsigned*, std::size_t, const double*);
  int (*fmi2SetInteger)(Component, const unsigned*, std::size_t, const int*);
  int (*fmi2SetBoolean)(Component, const unsigned*, std::size_t, const int*);
  int (*fmi2SetString)(Component, const unsigned*, std::size_t, const char* const*);
  int (*fmi2GetFMUstate)(Component, State*);
  int (*fmi2SetFMUstate)(Component, State);
  int (*fmi2FreeFMUstate)(Component, State*);
  int (*fmi2SerializedFMUstateSize)(Component, State, std::size_t*);
  int (*fmi2SerializeFMUstate)(Component, State, char*, std::size_t);
  int (*fmi2DeSerializeFMUstate)(Component, const char*, std::size_t, State*);
  int (*fmi2GetDirectionalDerivative)(Component, const unsigned*, std::size_t, const unsigned*, std::size_t,
                                      const double*, double*);
  int (*fmi2SetRealInputDerivatives)(Component, const unsigned*, std::size_t, const int*, const double*);
  int (*fmi2GetRealOutputDerivatives)(Component, const unsigned*, std::size_t, const int*, double*);
  int (*fmi2DoStep)(Component, double, double, int);
  int (*fmi2CancelStep)(Component);
  int (*fmi2GetStatus)(Component, int, int*);
  int (*fmi2GetRealStatus)(Component, int, double*);
  int (*fmi2GetIntegerStatus)(Component, int, int*);
  int (*fmi2GetBooleanStatus)(Component, int, int*);
  int (*fmi2GetStringStatus)(Component, int, const char**);
};

inline void* symbol(void* library, const char* name) {
#ifdef _WIN32
  void* const found = reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
#else
  void* const found = ::dlsym(library, name);
#endif
  if (found == nullptr) throw std::runtime_error(std::string("no function ") + name);
  return found;
}

/// Never unloaded.
inline Library load(const std::string& path) {
#ifdef _WIN32
  void* const library = LoadLibraryA(path.c_str());
  if (library == nullptr) throw std::runtime_error("cannot load " + path);
#else
  void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(::dlerror());
#endif
  Library made{};
#define BITROCK_RESOLVE(name) made.name = reinterpret_cast<decltype(made.name)>(symbol(library, #name))
  BITROCK_RESOLVE(fmi2GetTypesPlatform);
  BITROCK_RESOLVE(fmi2GetVersion);
  BITROCK_RESOLVE(fmi2SetDebugLogging);
  BITROCK_RESOLVE(fmi2Instantiate);
  BITROCK_RESOLVE(fmi2FreeInstance);
  BITROCK_RESOLVE(fmi2SetupExperiment);
  BITROCK_RESOLVE(fmi2EnterInitializationMode);
  BITROCK_RESOLVE(fmi2ExitInitializationMode);
  BITROCK_RESOLVE(fmi2Terminate);
  BITROCK_RESOLVE(fmi2Reset);
  BITROCK_RESOLVE(fmi2GetReal);
  BITROCK_RESOLVE(fmi2GetInteger);
  BITROCK_RESOLVE(fmi2GetBoolean);
  BITROCK_RESOLVE(fmi2GetString);
  BITROCK_RESOLVE(fmi2SetReal);
  BITROCK_RESOLVE(fmi2SetInteger);
  BITROCK_RESOLVE(fmi2SetBoolean);
  BITROCK_RESOLVE(fmi2SetString);
  BITROCK_RESOLVE(fmi2GetFMUstate);
  BITROCK_RESOLVE(fmi2SetFMUstate);
  BITROCK_RESOLVE(fmi2FreeFMUstate);
  BITROCK_RESOLVE(fmi2SerializedFMUstateSize);
  BITROCK_RESOLVE(fmi2SerializeFMUstate);
  BITROCK_RESOLVE(fmi2DeSerializeFMUstate);
  BITROCK_RESOLVE(fmi2GetDirectionalDerivative);
  BITROCK_RESOLVE(fmi2SetRealInputDerivatives);
  BITROCK_RESOLVE(fmi2GetRealOutputDerivatives);
  BITROCK_RESOLVE(fmi2DoStep);
  BITROCK_RESOLVE(fmi2CancelStep);
  BITROCK_RESOLVE(fmi2GetStatus);
  BITROCK_RESOLVE(fmi2GetRealStatus);
  BITROCK_RESOLVE(fmi2GetIntegerStatus);
  BITROCK_RESOLVE(fmi2GetBooleanStatus);
  BITROCK_RESOLVE(fmi2GetStringStatus);
#undef BITROCK_RESOLVE
  return made;
}

/// Appends what it is told to the string that is its environment.
inline void log_to_string(void* environment, const char*, int, const char*, const char* format, ...) {
  char text[8192];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof(text), format, arguments);
  va_end(arguments);
  *static_cast<std::string*>(environment) += std::string(text) + "\n";
}

/// Where the variables of a bit are, as its model description says.
enum Reference : unsigned { rotation, rop, weight, torque, axial_force, angle, depth, questions, clamped };

struct Outputs {
  double torque = 0.0, axial_force = 0.0, angle = 0.0, depth = 0.0;
  int questions = 0, clamped = 0;
  bool operator==(const Outputs&) const = default;
};

/// One instance, freed with the object.
class Instance {
 public:
  Instance(const Library& library, const std::string& guid, const std::string& location, int type = 1)
      : library_(library) {
    callbacks_ = {log_to_string, nullptr, nullptr, nullptr, &log};
    component = library_.fmi2Instantiate("bit", type, guid.c_str(), location.c_str(), &callbacks_, 0, 0);
  }
  ~Instance() { library_.fmi2FreeInstance(component); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// The order of a real importer: experiment, initialisation with the inputs, its end.
  int start(double speed, double advance, double push, double time = 0.0) {
    int worst = library_.fmi2SetupExperiment(component, 0, 0.0, time, 0, 0.0);
    worst |= library_.fmi2EnterInitializationMode(component);
    worst |= set(speed, advance, push);
    return worst | library_.fmi2ExitInitializationMode(component);
  }
  int set(double speed, double advance, double push) {
    const unsigned references[3] = {rotation, rop, weight};
    const double values[3] = {speed, advance, push};
    return library_.fmi2SetReal(component, references, 3, values);
  }
  int set_real(unsigned reference, double value) { return library_.fmi2SetReal(component, &reference, 1, &value); }
  int set_integer(unsigned reference, int value) { return library_.fmi2SetInteger(component, &reference, 1, &value); }
  int step(double from, double to) { return library_.fmi2DoStep(component, from, to - from, 0); }
  Outputs get() {
    const unsigned reals[4] = {torque, axial_force, angle, depth}, integers[2] = {questions, clamped};
    double r[4] = {};
    int i[2] = {};
    if (library_.fmi2GetReal(component, reals, 4, r) != ok || library_.fmi2GetInteger(component, integers, 2, i) != ok)
      throw std::runtime_error("outputs cannot be read: " + log);
    return {r[0], r[1], r[2], r[3], i[0], i[1]};
  }
  /// The whole state, as bytes.
  std::vector<char> state() {
    State saved = nullptr;
    std::size_t size = 0;
    if (library_.fmi2GetFMUstate(component, &saved) != ok ||
        library_.fmi2SerializedFMUstateSize(component, saved, &size) != ok)
      throw std::runtime_error("no state: " + log);
    std::vector<char> bytes(size);
    if (library_.fmi2SerializeFMUstate(component, saved, bytes.data(), size) != ok)
      throw std::runtime_error("no bytes: " + log);
    library_.fmi2FreeFMUstate(component, &saved);
    return bytes;
  }
  int set_state(const std::vector<char>& bytes) {
    State saved = nullptr;
    int worst = library_.fmi2DeSerializeFMUstate(component, bytes.data(), bytes.size(), &saved);
    if (worst == ok) worst = library_.fmi2SetFMUstate(component, saved);
    library_.fmi2FreeFMUstate(component, &saved);
    return worst;
  }

  Component component = nullptr;
  std::string log;

 private:
  Library library_;
  Callbacks callbacks_{};
};

}  // namespace importer
