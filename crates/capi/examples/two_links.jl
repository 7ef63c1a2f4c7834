# Effective mass of a planar arm with two hinges (models/planar_2r.urdf) at many configurations, by the C interface and by the mass
# matrix of the comment in that file.
#
#   LD_LIBRARY_PATH=PREFIX/lib julia two_links.jl MODEL
const percuss = "libpercuss"

check(status) = status == 0 || error(unsafe_string(@ccall percuss.percuss_error_message()::Cstring))

# struct percuss_contact of percuss.h.
mutable struct Contact
    link::Csize_t
    against::Csize_t
    point::NTuple{3,Cdouble}
    normal::NTuple{3,Cdouble}
    normal_given::Int32
    toward::Csize_t
    Contact() = new()
end

function effective_masses(path, link, point, normal, q::Matrix{Float64})
    model, system, assembly, batch = (Ref{Ptr{Cvoid}}(C_NULL) for _ in 1:4)
    contact, number = Contact(), Ref{Csize_t}(0)
    masses, outcomes = fill(NaN, size(q, 1)), zeros(Int32, size(q, 1))
    try
        check(@ccall percuss.percuss_model_load_file(path::Cstring, model::Ptr{Ptr{Cvoid}})::Int32)
        check(@ccall percuss.percuss_contact_init(contact::Ref{Contact})::Int32)
        check(@ccall percuss.percuss_model_find_link(model[]::Ptr{Cvoid}, link::Cstring, number::Ptr{Csize_t})::Int32)
        contact.link, contact.point, contact.normal = number[], point, normal
        check(@ccall percuss.percuss_system_new(model[]::Ptr{Cvoid}, C_NULL::Ptr{Cvoid}, system::Ptr{Ptr{Cvoid}})::Int32)
        check(@ccall percuss.percuss_assembly_new(system[]::Ptr{Cvoid}, C_NULL::Ptr{Cvoid}, assembly::Ptr{Ptr{Cvoid}})::Int32)
        check(@ccall percuss.percuss_batch_new(
            assembly[]::Ptr{Cvoid}, contact::Ref{Contact}, 1::Csize_t, batch::Ptr{Ptr{Cvoid}})::Int32)
        # Matrices of Julia are stored by columns: layout 1, the fastest.
        rows = size(q, 1)
        check(@ccall percuss.percuss_batch_run(
            batch[]::Ptr{Cvoid}, q::Ptr{Cdouble}, length(q)::Csize_t, COLUMN_MAJOR::Int32, rows::Csize_t, rows::Csize_t,
            outcomes::Ptr{Int32}, masses::Ptr{Cdouble}, C_NULL::Ptr{Cdouble}, C_NULL::Ptr{UInt32}, C_NULL::Ptr{Cvoid},
            C_NULL::Ptr{Cvoid})::Int32)
    finally
        @ccall percuss.percuss_batch_free(batch::Ptr{Ptr{Cvoid}})::Int32
        @ccall percuss.percuss_assembly_free(assembly::Ptr{Ptr{Cvoid}})::Int32
        @ccall percuss.percuss_system_free(system::Ptr{Ptr{Cvoid}})::Int32
        @ccall percuss.percuss_model_free(model::Ptr{Ptr{Cvoid}})::Int32
    end
    return masses
end

# PERCUSS_COLUMN_MAJOR.
const COLUMN_MAJOR = 1

q = [2π * (mod(0.618034 * k * c, 1) - 0.5) for k in 1:1000, c in 1:2]
m = effective_masses(ARGS[end], "outer", (0.4, 0.0, 0.0), (0.0, 1.0, 0.0), q)
a, b = 4 * 0.5^2 / 3 + 2 * 0.5^2, 2 * 0.4^2 / 3
expected = map(q[:, 2]) do elbow
    c = 2 * 0.5 * 0.4 / 2 * cos(elbow)
    M = [a+b+2c+0.3 b+c; b+c b+0.1]
    j = [0.5cos(elbow) + 0.4, 0.4]
    1 / (j' * (M \ j))
end
worst = maximum(abs.(m ./ expected .- 1))
println("$(length(m)) configurations, $(minimum(m)) to $(maximum(m)) kg, largest relative difference $worst")
@assert worst < 1e-13
