// Non-owning reference to a callable, so that a kernel that takes one is compiled only once.
#pragma once

namespace lommel {

template <class Signature>
class Reference;

// Of something that outlives it: an argument, never a member that is kept.
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
