#pragma once
#include <GL/glcorearb.h>

/// The GL functions that we use. Their table is filled by any getProcAddress, so that EGL, OSMesa, Qt and GLFW are
/// treated alike.
namespace velum::gpu {

class Context;
struct Limits;

// clang-format off
#define VELUM_GL_FUNCTIONS(X) \
  X(PFNGLATTACHSHADERPROC, AttachShader) \
  X(PFNGLBINDBUFFERPROC, BindBuffer) \
  X(PFNGLBINDBUFFERBASEPROC, BindBufferBase) \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer) \
  X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture) \
  X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit) \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray) \
  X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate) \
  X(PFNGLBLITNAMEDFRAMEBUFFERPROC, BlitNamedFramebuffer) \
  X(PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC, CheckNamedFramebufferStatus) \
  X(PFNGLCLEARNAMEDBUFFERDATAPROC, ClearNamedBufferData) \
  X(PFNGLCLEARNAMEDFRAMEBUFFERFVPROC, ClearNamedFramebufferfv) \
  X(PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC, ClearNamedFramebufferuiv) \
  X(PFNGLCLEARTEXIMAGEPROC, ClearTexImage) \
  X(PFNGLCLIENTWAITSYNCPROC, ClientWaitSync) \
  X(PFNGLCOMPILESHADERPROC, CompileShader) \
  X(PFNGLCOPYIMAGESUBDATAPROC, CopyImageSubData) \
  X(PFNGLCOPYNAMEDBUFFERSUBDATAPROC, CopyNamedBufferSubData) \
  X(PFNGLCREATEBUFFERSPROC, CreateBuffers) \
  X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers) \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram) \
  X(PFNGLCREATEQUERIESPROC, CreateQueries) \
  X(PFNGLCREATESHADERPROC, CreateShader) \
  X(PFNGLCREATETEXTURESPROC, CreateTextures) \
  X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays) \
  X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback) \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers) \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers) \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram) \
  X(PFNGLDELETEQUERIESPROC, DeleteQueries) \
  X(PFNGLDELETESHADERPROC, DeleteShader) \
  X(PFNGLDELETESYNCPROC, DeleteSync) \
  X(PFNGLDELETETEXTURESPROC, DeleteTextures) \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays) \
  X(PFNGLDEPTHFUNCPROC, DepthFunc) \
  X(PFNGLDEPTHMASKPROC, DepthMask) \
  X(PFNGLDISABLEPROC, Disable) \
  X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute) \
  X(PFNGLDISPATCHCOMPUTEINDIRECTPROC, DispatchComputeIndirect) \
  X(PFNGLDRAWARRAYSINSTANCEDBASEINSTANCEPROC, DrawArraysInstancedBaseInstance) \
  X(PFNGLDRAWELEMENTSINSTANCEDBASEVERTEXBASEINSTANCEPROC, DrawElementsInstancedBaseVertexBaseInstance) \
  X(PFNGLENABLEPROC, Enable) \
  X(PFNGLENABLEVERTEXARRAYATTRIBPROC, EnableVertexArrayAttrib) \
  X(PFNGLFENCESYNCPROC, FenceSync) \
  X(PFNGLFINISHPROC, Finish) \
  X(PFNGLFLUSHPROC, Flush) \
  X(PFNGLGENERATETEXTUREMIPMAPPROC, GenerateTextureMipmap) \
  X(PFNGLGETERRORPROC, GetError) \
  X(PFNGLGETGRAPHICSRESETSTATUSPROC, GetGraphicsResetStatus) \
  X(PFNGLGETINTEGERVPROC, GetIntegerv) \
  X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData) \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog) \
  X(PFNGLGETPROGRAMRESOURCEINDEXPROC, GetProgramResourceIndex) \
  X(PFNGLGETPROGRAMRESOURCEIVPROC, GetProgramResourceiv) \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv) \
  X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v) \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog) \
  X(PFNGLGETSHADERIVPROC, GetShaderiv) \
  X(PFNGLGETSTRINGPROC, GetString) \
  X(PFNGLGETSTRINGIPROC, GetStringi) \
  X(PFNGLGETTEXTUREIMAGEPROC, GetTextureImage) \
  X(PFNGLGETTEXTURESUBIMAGEPROC, GetTextureSubImage) \
  X(PFNGLLINKPROGRAMPROC, LinkProgram) \
  X(PFNGLMAPNAMEDBUFFERRANGEPROC, MapNamedBufferRange) \
  X(PFNGLMEMORYBARRIERPROC, MemoryBarrier) \
  X(PFNGLMULTIDRAWARRAYSINDIRECTPROC, MultiDrawArraysIndirect) \
  X(PFNGLMULTIDRAWELEMENTSINDIRECTPROC, MultiDrawElementsIndirect) \
  X(PFNGLNAMEDBUFFERSTORAGEPROC, NamedBufferStorage) \
  X(PFNGLNAMEDBUFFERSUBDATAPROC, NamedBufferSubData) \
  X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC, NamedFramebufferDrawBuffers) \
  X(PFNGLNAMEDFRAMEBUFFERTEXTUREPROC, NamedFramebufferTexture) \
  X(PFNGLOBJECTLABELPROC, ObjectLabel) \
  X(PFNGLOBJECTPTRLABELPROC, ObjectPtrLabel) \
  X(PFNGLPIXELSTOREIPROC, PixelStorei) \
  X(PFNGLPOPDEBUGGROUPPROC, PopDebugGroup) \
  X(PFNGLPROGRAMUNIFORM1FPROC, ProgramUniform1f) \
  X(PFNGLPROGRAMUNIFORM1IPROC, ProgramUniform1i) \
  X(PFNGLPROGRAMUNIFORM2IPROC, ProgramUniform2i) \
  X(PFNGLPROGRAMUNIFORM4FPROC, ProgramUniform4f) \
  X(PFNGLPROGRAMUNIFORM4IPROC, ProgramUniform4i) \
  X(PFNGLPUSHDEBUGGROUPPROC, PushDebugGroup) \
  X(PFNGLQUERYCOUNTERPROC, QueryCounter) \
  X(PFNGLSHADERSOURCEPROC, ShaderSource) \
  X(PFNGLTEXTUREBUFFERPROC, TextureBuffer) \
  X(PFNGLTEXTUREPARAMETERIPROC, TextureParameteri) \
  X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D) \
  X(PFNGLTEXTURESTORAGE3DPROC, TextureStorage3D) \
  X(PFNGLTEXTURESUBIMAGE2DPROC, TextureSubImage2D) \
  X(PFNGLTEXTURESUBIMAGE3DPROC, TextureSubImage3D) \
  X(PFNGLUSEPROGRAMPROC, UseProgram) \
  X(PFNGLVERTEXARRAYATTRIBBINDINGPROC, VertexArrayAttribBinding) \
  X(PFNGLVERTEXARRAYATTRIBFORMATPROC, VertexArrayAttribFormat) \
  X(PFNGLVERTEXARRAYATTRIBIFORMATPROC, VertexArrayAttribIFormat) \
  X(PFNGLVERTEXARRAYBINDINGDIVISORPROC, VertexArrayBindingDivisor) \
  X(PFNGLVERTEXARRAYELEMENTBUFFERPROC, VertexArrayElementBuffer) \
  X(PFNGLVERTEXARRAYVERTEXBUFFERPROC, VertexArrayVertexBuffer) \
  X(PFNGLVIEWPORTPROC, Viewport)
// clang-format on

struct GlTable {
#define VELUM_GL_MEMBER(type, name) type name = nullptr;
  VELUM_GL_FUNCTIONS(VELUM_GL_MEMBER)
#undef VELUM_GL_MEMBER
  /// Where a window made the context: tells which context of the window system is current now; `context` is the one
  /// that these functions belong to.
  const void* (*current)() = nullptr;
  const void* context = nullptr;
  const Limits* limits = nullptr;
  Context* owner = nullptr;
  unsigned number = 0;          ///< see contextNumber()
  mutable bool isLost = false;  ///< The driver has said that it lost the context.
  bool compilesBeside = false;  ///< The driver compiles on threads of its own and says when a program is done.
  GLuint emptyVertexArray = 0;  ///< In the core profile a vertex array must be bound for every draw, also where
                                ///< vertices are made from their numbers.
};

/// The table of this thread's current context. A context is thread-bound in GL itself, hence thread_local and no
/// parameter.
const GlTable& gl();
bool hasGl();
void setGl(const GlTable* table);

/// While an object of this class lives, its thread makes requests that the driver may refuse, and the caller checks
/// whether it did. What the driver then reports does not count as an error of ours, so that a refusal is not reported
/// twice.
class MayRefuse {
 public:
  MayRefuse();
  ~MayRefuse();
  MayRefuse(const MayRefuse&) = delete;
  MayRefuse& operator=(const MayRefuse&) = delete;
};

}  // namespace velum::gpu
