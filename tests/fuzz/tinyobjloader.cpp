// The library once more, so that its accesses to memory are watched too; the packaged one is not built for
// that.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
