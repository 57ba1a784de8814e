#pragma once
/// The C interface of FMI 2.0 [Fmi2], as far as types and constants go: what an importer passes and expects. Declared
/// here from the standard, whose own headers no Debian package holds. Names are the standard's.

#include <stddef.h>

extern "C" {

typedef void* fmi2Component;              ///< an instance of the FMU; only the FMU knows what is there
typedef void* fmi2ComponentEnvironment;   ///< handed back to the importer with each message
typedef void* fmi2FMUstate;               ///< a kept state of an instance
typedef unsigned int fmi2ValueReference;  ///< number of a variable (variable.hpp)
typedef double fmi2Real;                  ///< in the unit of the model description
typedef int fmi2Integer;                  ///< also of enumerations
typedef int fmi2Boolean;                  ///< fmi2False or fmi2True
typedef char fmi2Char;                    ///< of UTF-8
typedef const fmi2Char* fmi2String;       ///< ends with a zero
typedef char fmi2Byte;                    ///< of a state that is written out

/// Values of fmi2Boolean.
enum {
  fmi2False = 0,  ///< no
  fmi2True = 1    ///< yes
};

/// How a call ended; the instance is good for further calls up to fmi2Discard.
typedef enum {
  fmi2OK,       ///< done
  fmi2Warning,  ///< done, with a message
  fmi2Discard,  ///< not done: a value was refused, or only a part of the step was taken
  fmi2Error,    ///< this instance cannot go on
  fmi2Fatal,    ///< no instance can
  fmi2Pending   ///< the step goes on behind the call
} fmi2Status;

/// What an importer makes an instance for.
typedef enum {
  fmi2ModelExchange,  ///< the importer integrates
  fmi2CoSimulation    ///< the FMU takes its steps itself
} fmi2Type;

/// What an importer may ask of a step that is pending or was discarded.
typedef enum {
  fmi2DoStepStatus,        ///< an fmi2Status: whether it has ended, and how
  fmi2PendingStatus,       ///< a text about the step that goes on
  fmi2LastSuccessfulTime,  ///< a time [s]: how far it came
  fmi2Terminated           ///< a truth: the FMU wants to end
} fmi2StatusKind;

/// The message is a format of printf; ours asks for no further arguments.
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment environment, fmi2String instance_name, fmi2Status status,
                                   fmi2String category, fmi2String message, ...);
/// As calloc of the C library: zeros, or null where there is no memory.
typedef void* (*fmi2CallbackAllocateMemory)(size_t count, size_t size);
/// Of what fmi2CallbackAllocateMemory gave.
typedef void (*fmi2CallbackFreeMemory)(void* memory);
/// Told when a step that was fmi2Pending has ended, and how.
typedef void (*fmi2StepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);

/// What an importer lets its FMUs call. Ours calls the logger alone.
typedef struct {
  fmi2CallbackLogger logger;                      ///< takes messages
  fmi2CallbackAllocateMemory allocateMemory;      ///< not called by ours
  fmi2CallbackFreeMemory freeMemory;              ///< not called by ours
  fmi2StepFinished stepFinished;                  ///< not called by ours, whose steps end with the call
  fmi2ComponentEnvironment componentEnvironment;  ///< first argument of the logger
} fmi2CallbackFunctions;

}  // extern "C"
