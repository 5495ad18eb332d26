#include <graze/narrowphase/verdict.h>
