// Non-owning reference to a callable, so that a kernel with such an argument is compiled only once.
#pragma once

namespace lommel {

template <class Signature>
class Reference;

// The callable must outlive the reference, which is therefore used as a function argument and not stored.
template <class Result, class... Arguments>
class Reference<Result(Arguments...)> {
   public:
    template <class Function>
    Reference(const Function& function)
        : function_(&function), call_([](const void* of, Arguments... arguments) -> Result {
              return (*static_cast<const Function*>(of))(arguments...);
          }) {}
    Result operator()(Arguments... arguments) const { return call_(function_, arguments...); }

   private:
    const void* function_;
    Result (*call_)(const void*, Arguments...);
};

}  // namespace lommel
