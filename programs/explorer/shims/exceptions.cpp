// C++ exceptions for a C++ library that was built without: the functions which the compiler calls, over WebAssembly's
// own exceptions. Types are compared by libc++abi's type_info. One thread; no exception specifications, no foreign
// exceptions.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

namespace {

/// What stands before a thrown object.
struct Header {
    const std::type_info* type;
    void* (*destroy)(void*);  // returns its argument, as all destructors do here
    Header* below;            // of those being handled
    void* as_caught;          // the object as the handler's type
    int references, handlers;
    bool rethrown;
};
constexpr std::size_t header_size = (sizeof(Header) + 15) / 16 * 16;

Header* header_of(void* object) { return reinterpret_cast<Header*>(static_cast<char*>(object) - header_size); }
void* object_of(Header* h) { return reinterpret_cast<char*>(h) + header_size; }

Header* handled = nullptr;  // the one caught last
int in_flight = 0;

void release(Header* h) {
    if (--h->references > 0) return;
    if (h->destroy) h->destroy(object_of(h));
    std::free(h);
}

/// libc++abi's base of all types that it makes, as far as its table of virtual functions is concerned.
struct CatchableType : std::type_info {
    virtual void first_of_no_use() const = 0;
    virtual void second_of_no_use() const = 0;
    virtual bool can_catch(const std::type_info* thrown, void*& object) const = 0;
};

std::uintptr_t read_unsigned(const std::uint8_t*& at) {
    std::uintptr_t y = 0;
    for (int shift = 0;; shift += 7) {
        const std::uint8_t byte = *at++;
        y |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
        if (!(byte & 0x80)) return y;
    }
}
std::intptr_t read_signed(const std::uint8_t*& at) {
    std::intptr_t y = 0;
    for (int shift = 0;;) {
        const std::uint8_t byte = *at++;
        y |= static_cast<std::intptr_t>(byte & 0x7f) << shift;
        shift += 7;
        if (byte & 0x80) continue;
        if ((byte & 0x40) && shift < 32) y |= -(std::intptr_t{1} << shift);
        return y;
    }
}

/// The number of the first handler in a function's table that takes the exception; 0: none.
int handler_for(const std::uint8_t* table, std::uintptr_t pad, Header* h) {
    constexpr std::uint8_t omitted = 0xff;
    if (*table++ != omitted) std::abort();  // pads have numbers, not places
    const bool has_types = *table++ != omitted;
    const std::uint8_t* types = nullptr;
    if (has_types) {
        const std::uintptr_t offset = read_unsigned(table);
        types = table + offset;
    }
    ++table;  // numbers are LEB128
    const std::uintptr_t size = read_unsigned(table);
    const std::uint8_t* const actions = table + size;
    for (;; --pad) {
        read_unsigned(table);  // the pad's number: they are in order
        const std::uintptr_t action = read_unsigned(table);
        if (pad > 0) continue;
        if (action == 0) return 0;
        for (const std::uint8_t* at = actions + action - 1;;) {
            const std::intptr_t type = read_signed(at);
            const std::uint8_t* const here = at;
            const std::intptr_t next = read_signed(at);
            if (type > 0) {
                const auto* wanted = *reinterpret_cast<const CatchableType* const*>(
                    types - static_cast<std::uintptr_t>(type) * sizeof(void*));
                void* object = object_of(h);
                if (!wanted || wanted->can_catch(h->type, object)) {
                    h->as_caught = object;
                    return static_cast<int>(type);
                }
            }
            if (next == 0) return 0;
            at = here + next;
        }
    }
}

}  // namespace

extern "C" {

/// What a landing pad says and is told.
struct LandingPad {
    std::uintptr_t pad, table, handler;
};
thread_local LandingPad __wasm_lpad_context = {};

int _Unwind_CallPersonality(void* object) {
    Header* h = header_of(object);
    h->as_caught = object;
    __wasm_lpad_context.handler = static_cast<std::uintptr_t>(
        __wasm_lpad_context.table
            ? handler_for(reinterpret_cast<const std::uint8_t*>(__wasm_lpad_context.table), __wasm_lpad_context.pad, h)
            : 0);
    return 0;
}
int __gxx_wasm_personality_v0() { std::abort(); }

void* __cxa_allocate_exception(std::size_t size) noexcept {
    void* memory = std::malloc(header_size + size);
    if (!memory) std::abort();
    return object_of(new (memory) Header{});
}
void __cxa_free_exception(void* object) noexcept { std::free(header_of(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
    Header* h = header_of(object);
    h->type = type;
    h->destroy = destroy;
    h->references = 1;
    ++in_flight;
    __builtin_wasm_throw(0, object);
}
void* __cxa_get_exception_ptr(void* object) noexcept { return header_of(object)->as_caught; }
void* __cxa_begin_catch(void* object) noexcept {
    Header* h = header_of(object);
    h->rethrown = false;
    if (h->handlers++ == 0) {
        h->below = handled;
        handled = h;
    }
    --in_flight;
    if (!h->as_caught) h->as_caught = object;
    return h->as_caught;
}
void __cxa_end_catch() {
    Header* h = handled;
    if (!h) return;
    if (--h->handlers > 0) return;
    handled = h->below;
    if (!h->rethrown) release(h);
}
[[noreturn]] void __cxa_rethrow() {
    if (!handled) std::terminate();
    handled->rethrown = true;
    ++in_flight;
    __builtin_wasm_throw(0, object_of(handled));
}

bool __cxa_uncaught_exception() noexcept { return in_flight != 0; }
unsigned __cxa_uncaught_exceptions() noexcept { return static_cast<unsigned>(in_flight); }
void __cxa_increment_exception_refcount(void* object) noexcept {
    if (object) ++header_of(object)->references;
}
void __cxa_decrement_exception_refcount(void* object) noexcept {
    if (object) release(header_of(object));
}
void* __cxa_current_primary_exception() noexcept {
    if (!handled) return nullptr;
    ++handled->references;
    return object_of(handled);
}
void __cxa_rethrow_primary_exception(void* object) {
    if (!object) return;
    Header* h = header_of(object);
    ++h->references;
    ++in_flight;
    __builtin_wasm_throw(0, object);
}
}
